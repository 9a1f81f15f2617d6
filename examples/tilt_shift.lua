-- Tilt and shift: a town that looks like a model, through a lens that is leaned and slid.
--
--   lapidary render tilt_shift.lua
--   lapidary render tilt_shift.lua --set tilt=0      the same lens, held straight
--   lapidary render tilt_shift.lua --set aperture=0  a pinhole: everything is sharp
--
-- A plane that is sharp usually stands across the view. `tilt` leans it: here it cuts through the
-- town from the towers' tops to the street, so that only one slice is sharp, and what is before and
-- behind it, below and above, melts away. `shift` slides the picture over the film, so the camera
-- can look straight ahead and walls stay upright. The blades of the aperture show in the lamps.

local tilt = param("tilt", -40)
local aperture = param("aperture", 0.9)

-- Numbers that look random and stay the same.
local seed = 7
local function random()
  seed = (seed * 16807) % 2147483647
  return seed / 2147483647
end

local walls = { "#e0d2b8", "#d89a6a", "#efe8da", "#a9b7c2", "#e0b05c", "#f2eee4", "#c8d0b0" }
local function wall() return matte(walls[1 + math.floor(random() * #walls)]) end

--- A house with a roof, or a tower with rows of windows cut into it.
local function house(w, d, h)
  local eaves = w / 2 + 0.06
  local roof = prism { points = { { -eaves, 0 }, { eaves, 0 }, { 0, 0.3 * w } }, height = d + 0.12 }
    :rotate { x = 90 }:translate { 0, d / 2 + 0.06, h }
  return group {
    box { size = { w, d, h } }:translate { 0, 0, h / 2 }:material(wall()),
    roof:material(matte(random() > 0.4 and "#a4533c" or "#6d747a")),
  }
end

local function tower(w, d, h)
  local body = box { size = { w, d, h } }:translate { 0, 0, h / 2 }
  local windows = {}
  for level = 0, math.floor((h - 0.4) / 0.35) - 1 do
    local z = 0.45 + 0.35 * level
    windows[#windows + 1] = box { size = { w - 0.2, d + 1, 0.16 } }:translate { 0, 0, z }
    windows[#windows + 1] = box { size = { w + 1, d - 0.2, 0.16 } }:translate { 0, 0, z }
  end
  local core = box { size = { w - 0.1, d - 0.1, h - 0.1 } }:translate { 0, 0, h / 2 }
  return group {
    (body - union(windows)):material(wall()),
    core:material(metal { color = { 0.10, 0.14, 0.18 }, roughness = 0.3 }),
  }
end

local function tree(x, y)
  local s = 0.8 + 0.5 * random()
  return group {
    cylinder { from = { 0, 0, 0 }, to = { 0, 0, 0.25 }, radius = 0.03 }:material(matte "#5a4632"),
    sphere { center = { 0, 0, 0.38 }, radius = 0.2 }:material(matte "#4f7a3a"),
  }:scale(s):translate { x, y, 0 }
end

local light = emissive { radiance = { 18, 12, 6 } }
local function lamp(x, y)
  return group {
    cylinder { from = { x, y, 0 }, to = { x, y, 0.5 }, radius = 0.015 }:material(matte "#303030"),
    sphere { center = { x, y, 0.52 }, radius = 0.07 }:material(light),
  }
end

-- Blocks of houses between streets.
local town = {}
for row = 0, 13 do
  for column = -7, 6 do
    local x, y = 1.6 * column + 0.8, 1.7 * row
    local w, d = 0.8 + 0.3 * random(), 0.8 + 0.3 * random()
    local tall = random()
    local built
    if tall > 0.72 then
      built = tower(w, d, 1.2 + 2.2 * random())
    else
      built = house(w, d, 0.5 + 0.5 * random())
    end
    town[#town + 1] = built:translate { x, y, 0 }
    if random() > 0.3 then town[#town + 1] = tree(x + 0.75, y - 0.55) end
    if random() > 0.7 then town[#town + 1] = lamp(x - 0.68, y - 0.75) end
  end
end

return scene {
  camera = perspective {
    from = { 0.4, -16, 13 }, at = { 0.1, 6, 0.4 }, fov = 17,
    aperture = aperture, focus = { 0, 5.2, 0.6 }, blades = 6, blade_rotation = 30,
    tilt = { x = tilt }, shift = { y = -0.03 },
  },
  lights = {
    sun { direction = { -0.8, 0.25, -0.6 }, irradiance = 6, color = "#ffe9c8", angle = 1 },
    environment { color = { 0.40, 0.55, 0.80 } },
  },
  objects = {
    plane { material = matte "#77746e" },
    town,
  },
  render = { size = { 800, 450 }, samples = 96, max_depth = 5 },
}
