-- Perforated: a disk with many holes, set like the seeds of a sunflower, and the light behind it.
--
--   lapidary render perforated.lua
--   lapidary render perforated.lua --set holes=1000000
--
-- All holes are taken from the plate at once. A ray looks only at those it comes near, so a million
-- of them take a few times as long as a hundred, not ten thousand times. They end where the plate
-- ends, in the very same planes: a cutter need not stick out to cut cleanly.

local count = param("holes", 3000)
local radius, thickness = 2, 0.02

local golden = math.pi * (3 - math.sqrt(5))
local spacing = radius * 0.96 / math.sqrt(count) -- a hole has the area of a disk of this radius

local holes = {}
for i = 1, count do
  local r, angle = spacing * math.sqrt(i - 0.5), i * golden
  local x, z = r * math.cos(angle), r * math.sin(angle)
  -- Petals: the radius of a hole goes with its place.
  local petals = math.cos(8 * math.atan(z, x) + 5 * r) * math.sin(math.pi * r / radius)
  holes[i] = cylinder {
    from = { x, -thickness / 2, z }, to = { x, thickness / 2, z },
    radius = spacing * (0.56 + 0.26 * petals),
  }
end

local disk = cylinder {
  from = { 0, -thickness / 2, 0 }, to = { 0, thickness / 2, 0 }, radius = radius,
}
local plate = difference { disk, holes }:material(matte "#8a4526")

return scene {
  camera = perspective { from = { -3.4, -11, 6 }, at = { -0.2, -1.2, 1.45 }, fov = 29.5 },
  lights = {
    sphere_light { center = { 0.8, 4.2, 6.2 }, radius = 0.03, power = 2600, temperature = 3600 },
    rectangle_light {
      center = { -6, -5, 5 }, size = { 5, 5 }, at = { 0, 0, 1.5 }, radiance = { 0.7, 0.9, 1.2 },
    },
    environment { color = { 0.05, 0.06, 0.08 } },
  },
  objects = {
    plate:rotate { x = 8 }:translate { 0, 0, radius }:name "plate",
    plane { material = matte "#b9b2a4", name = "floor" },
  },
  render = { size = { 960, 640 }, samples = 128 },
}
