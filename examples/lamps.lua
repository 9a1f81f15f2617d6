-- Lamps: red, green and blue light meet in white, but where glass stands in the way it sorts them.
--
--   lapidary render lamps.lua
--   lapidary render lamps.lua --set radius=0.4       larger lamps, softer edges
--   lapidary render lamps.lua --set spread=25        the lamps closer together
--
-- Every solid throws three shadows, each in the colour of the two lamps that still see the floor,
-- and three caustics in the colours of the lamps themselves. Where two of them cross, they add up.

local radius = param("radius", 0.04)
local spread = param("spread", 50) -- of the lamps from straight above, in degrees

--- A lamp in a direction, at a distance of 14.
local function lamp(angle, color)
  local a, s = math.rad(angle), math.rad(spread)
  return sphere_light {
    center = { 14 * math.sin(s) * math.cos(a), 14 * math.sin(s) * math.sin(a), 14 * math.cos(s) },
    radius = radius, color = color, power = 19,
  }
end

local clear = glass "N-BK7"

-- A cube with a round hole through it, its corners ground off by a ball.
local cube = (box { size = { 1.1, 1.1, 1.1 } } & sphere { radius = 0.76 })
  - cylinder { from = { 0, 0, -1 }, to = { 0, 0, 1 }, radius = 0.24 }

return scene {
  unit = "dm",
  camera = perspective { from = { 0, -7.2, 6.9 }, at = { 0, -0.05, 0.1 }, fov = 31 },
  lights = {
    lamp(90, { 1, 0.04, 0.03 }), lamp(210, { 0.03, 0.9, 0.08 }), lamp(330, { 0.04, 0.12, 1 }),
    environment { color = { 0.02, 0.02, 0.02 } },
  },
  objects = {
    sphere { center = { -0.1, 0.5, 0.75 }, radius = 0.75, material = clear }:name "ball",
    cube:translate { z = 0.55 }:rotate { z = 25 }:translate { 1.75, -0.35, 0 }
      :material(clear):name "cube",
    torus {
      center = { -1.75, -0.6, 0.24 }, major_radius = 0.55, minor_radius = 0.24, material = clear,
    }:name "ring",
    sphere { center = { 0.2, -1.35, 0.3 }, radius = 0.3, material = clear }:name "marble",
    plane { material = matte "#f0f0f0", name = "floor" },
  },
  render = { size = { 800, 600 }, samples = 192, max_depth = 16 },
}
