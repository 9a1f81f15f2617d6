-- Dice: a cube, rounded by a ball, and three ways to give it spots.
--
--   lapidary render dice.lua
--   lapidary render dice.lua --set roundness=0.8     nearly a ball
--
-- What a body wears where it is cut, the cutter decides: a ball of black matte leaves a black
-- hollow. Where a cutter wears nothing, the hollow is of the body's own material. And a spot that
-- is a body of its own fills whatever it overlaps, because what is opaque goes before what is
-- clear; neither knows of the other, and there is no gap between them to close.

local roundness = param("roundness", 0.46) -- 0: a ball touches the corners; 1: the faces

-- The cube reaches from -1 to 1; its corners are sqrt(3) from the middle, its edges sqrt(2).
local shape = box { size = { 2, 2, 2 } }
  & sphere { radius = math.sqrt(3) + roundness * (1.02 - math.sqrt(3)) }

-- Where spots are on a face, in steps from its middle.
local patterns = {
  { { 0, 0 } },
  { { -1, -1 }, { 1, 1 } },
  { { -1, -1 }, { 0, 0 }, { 1, 1 } },
  { { -1, -1 }, { -1, 1 }, { 1, -1 }, { 1, 1 } },
  { { -1, -1 }, { -1, 1 }, { 0, 0 }, { 1, -1 }, { 1, 1 } },
  { { -1, -1 }, { -1, 0 }, { -1, 1 }, { 1, -1 }, { 1, 0 }, { 1, 1 } },
}

-- From the middle of a face along it: 1 is opposite to 6, 2 to 5, 3 to 4, and 1, 2, 3 go around
-- their common corner counter-clockwise.
local faces = {
  function(u, v, out) return { u, v, out } end,
  function(u, v, out) return { u, -out, v } end,
  function(u, v, out) return { out, u, v } end,
  function(u, v, out) return { -out, u, v } end,
  function(u, v, out) return { u, out, v } end,
  function(u, v, out) return { u, v, -out } end,
}

--- All 21 spots as one solid: balls of a radius whose centres are `out` from the die's middle.
local function spots(radius, out)
  local balls = {}
  for number, place in ipairs(faces) do
    for _, step in ipairs(patterns[number]) do
      local center = place(0.46 * step[1], 0.46 * step[2], out)
      balls[#balls + 1] = sphere { center = center, radius = radius }
    end
  end
  return union(balls)
end

local ivory, ink = matte "#e9dfc8", matte "#221d18"
local ruby = glass { ior = 1.5, color = { 0.85, 0.09, 0.10 }, distance = 1.5 }

local painted = (shape - spots(0.28, 1.14):material(ink)):material(ivory):name "painted"
local hollow = (shape - spots(0.24, 1.06)):material(metal { "gold", roughness = 0.3 }):name "hollow"
local inlaid = group {
  shape:material(ruby),
  (spots(0.19, 1) & shape):material(ivory), -- flush with the faces
}:name "inlaid"

local function softbox(center, size, radiance)
  return rectangle_light {
    center = center, size = size, at = { 0, 0, 1 }, radiance = radiance, name = "softbox",
  }
end

return scene {
  camera = perspective {
    from = { 1.2, -15, 8 }, at = { 0.1, 0.1, 1.05 }, fov = 19,
    aperture = 0.12, focus = { 0.5, -1, 1 },
  },
  lights = {
    softbox({ -8, -2, 8 }, { 7, 7 }, { 4.4, 4.2, 3.9 }),
    softbox({ 8, 3, 5 }, { 3, 6 }, { 3.2, 3.5, 4.0 }),
    softbox({ 2, 8, 11 }, { 12, 6 }, { 3.0, 2.9, 2.8 }),
    softbox({ -2, -14, 9 }, { 12, 7 }, { 3.6, 3.5, 3.4 }),
    environment { color = { 0.42, 0.43, 0.45 } },
  },
  objects = {
    plane { material = matte "#4f8a72", name = "felt" },
    painted:rotate { y = -90, z = 28 }:translate { -2.5, 0.7, 1 },
    inlaid:rotate { z = -52 }:translate { 0.5, -1.2, 1 },
    hollow:rotate { x = 90, z = -14 }:translate { 2.6, 1.5, 1 },
  },
  render = { size = { 960, 540 }, samples = 256 },
}
