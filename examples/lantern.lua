-- Lantern: a pierced shade of burnt clay, and in it a light that is a solid of solids.
--
--   lapidary render lantern.lua
--   lapidary render lantern.lua --set holes=600
--   lapidary render lantern.lua --set power=12 --set temperature=1900   an ember
--
-- What glows is a ball cut down to a cube: any solid can wear a light, made of however many others,
-- and sends out the watts that it says, spread over the surface that is left. Each hole of the shade
-- is cut along a line of its own from the middle, so the light leaves through all of them, and writes
-- them on the wall.

local count = param("holes", 240)
local power = param("power", 20)
local temperature = param("temperature", 2700)

local middle, radius, wall = { 0, 0, 1.5 }, 1, 0.035
local golden = math.pi * (3 - math.sqrt(5))

local function around(x, y, z, distance)
  return { middle[1] + x * distance, middle[2] + y * distance, middle[3] + z * distance }
end

-- Holes like the seeds of a sunflower on a sphere, in bands of large and small ones. A cap above
-- and a collar below stay whole.
local holes = {}
local spacing = math.sqrt(4 / count) -- a hole's share of the unit sphere is a disk of this radius
for i = 1, count do
  local z = 1 - 2 * (i - 0.5) / count
  if z < 0.86 and z > -0.9 then
    local r, angle = math.sqrt(1 - z * z), i * golden
    local x, y = r * math.cos(angle), r * math.sin(angle)
    local size = spacing * (0.5 + 0.28 * math.sin(11 * z))
    holes[#holes + 1] = cone {
      from = around(x, y, z, 0.8), to = around(x, y, z, 1.1),
      radius = 0.8 * size, radius2 = 1.1 * size,
    }
  end
end

local function ball(r) return sphere { center = middle, radius = r } end
local function ring(height, r, thick)
  return torus { center = { 0, 0, height }, major_radius = r, minor_radius = thick }
end

local clay = matte "#33200f"
local shade = difference { ball(radius), ball(radius - wall), holes }
local fittings = ring(2.38, 0.5, 0.03) + ring(0.62, 0.47, 0.03)
  + (sphere { center = { 0, 0, 2.44 }, radius = 0.2 } - ball(radius))
  + torus {
    center = { 0, 0, 2.86 }, axis = { 0, 1, 0.25 }, major_radius = 0.24, minor_radius = 0.035,
  }
  + (cone { from = { 0, 0, 0 }, to = { 0, 0, 0.75 }, radius = 0.62, radius2 = 0.4 } - ball(radius))

-- The light: a ball cut down to a cube with round corners.
local core = (sphere { radius = 0.06 } & box { size = { 0.09, 0.09, 0.09 } })
  :rotate { x = 35, y = 20, z = 15 }:translate(middle)

return scene {
  unit = "dm",
  camera = perspective { from = { 2.9, -9.6, 2.7 }, at = { -0.35, 0, 1.5 }, fov = 34 },
  lights = { environment { color = { 0.05, 0.062, 0.095 } } },
  objects = {
    (shade + fittings):material(clay):name "lantern",
    core:material(emissive { power = power, temperature = temperature })
      :name "core",
    plane { material = matte "#8c7b68", name = "table" },
    plane {
      point = { 0, 2.6, 0 }, normal = { 0.12, -1, 0 }, material = matte "#b8b2a6", name = "wall",
    },
  },
  render = { size = { 720, 512 }, samples = 256 },
}
