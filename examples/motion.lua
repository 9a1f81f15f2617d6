-- Motion: a top that spins, a hoop that rolls and a ball that drops, in an instant.
--
--   lapidary render motion.lua
--   lapidary render motion.lua --set shutter=1       all of the frame
--   lapidary render motion.lua --set shutter=0       a flash: all of it stands still
--
-- `object:motion { ... }` says where an object is when the frame ends, from where it stands when it
-- begins: how far it goes, how far it turns. Motions nest: the hoop turns in a group that rolls on.
-- The shutter of the camera says how much of the frame is on the picture.

local shutter = param("shutter", 0.5)

local brass = metal { "gold", roughness = 0.16 }
local enamel = matte "#a8241f"
local ivory = matte "#e6dcc4"

-- A top: turned on a lathe, with a band of inlays that show how it spins.
local top = lathe {
  points = { { 0, 0 }, { 0.1, 0.12 }, { 0.92, 0.8 }, { 1, 0.95 }, { 0.92, 1.08 }, { 0.3, 1.2 },
             { 0.12, 1.35 }, { 0.1, 2.0 }, { 0.16, 2.1 }, { 0.1, 2.2 }, { 0, 2.22 } },
  material = enamel,
}
local inlays = {}
for i = 0, 5 do
  inlays[#inlays + 1] = sphere { radius = 0.15, center = { 0.93, 0, 0.95 } }
    :rotate { z = 60 * i }:material(brass)
end

-- A hoop of radius 0.9 that rolls for as far as its turn takes it.
local radius, turn = 0.9, 36
local hoop = group {
  torus { major_radius = 0.82, minor_radius = 0.08, material = brass },
  cylinder { from = { -0.8, 0, 0 }, to = { 0.8, 0, 0 }, radius = 0.035, material = ivory },
  cylinder { from = { 0, -0.8, 0 }, to = { 0, 0.8, 0 }, radius = 0.035, material = ivory },
  sphere { radius = 0.17, material = enamel },
}:rotate { x = 90 }
local way = radius * math.rad(turn)

local function ball(r, material) return sphere { radius = r, material = material } end

local function softbox(center, size, radiance)
  return rectangle_light {
    center = center, size = size, at = { 0, 0, 1 }, radiance = radiance, name = "softbox",
  }
end

return scene {
  camera = perspective {
    from = { 0, -11, 3.4 }, at = { 0.1, 0, 1.05 }, fov = 24, shutter = shutter,
  },
  lights = {
    softbox({ -5, -4, 7 }, { 4, 4 }, { 9, 8.4, 7.6 }),
    softbox({ 6, 1, 5 }, { 3, 5 }, { 2.0, 2.6, 3.6 }),
    environment { color = { 0.42, 0.44, 0.48 } },
  },
  objects = {
    plane { material = matte "#8d9aa0", name = "table" },
    group { top, inlays }:motion { rotate = { z = 70 } }
      :rotate { x = -9, y = 7 }:translate { -0.9, 0.3, 0 }:name "top",
    group { hoop:motion { rotate = { y = turn } } }:motion { translate = { way, 0, 0 } }
      :rotate { z = 18 }:translate { 1.25, 0.9, radius }:name "hoop",
    ball(0.2, metal "silver"):translate { 2.35, -1.6, 1.6 }
      :motion { translate = { 0.1, 0, -0.9 } }:name "drop",
    ball(0.3, ivory):translate { -2.6, -1.2, 0.3 }:motion { translate = { 0.5, -0.1, 0 } },
    ball(0.42, metal { "silver", roughness = 0.05 }):translate { -2.6, 1.6, 0.42 },
    ball(0.24, metal { "copper", roughness = 0.1 }):translate { 0.5, -1.9, 0.24 },
  },
  render = { size = { 800, 450 }, samples = 96, max_depth = 10 },
}
