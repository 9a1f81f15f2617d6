-- Caustics: a small lamp behind a glass of tea, a ball and a lens, and what each does to its light.
--
--   lapidary render caustics.lua
--   lapidary render caustics.lua --set lamp=0.5      a large lamp blurs them
--   lapidary render caustics.lua --set level=0.3     the tea nearly drunk
--
-- Light that has gone through glass is gathered in some places and missing in others. Where a fold
-- of it comes to lie on the table, its edge is as sharp as the lamp is small. The lens stands in a
-- block that was cut with it, and the tea reaches into the wall of its glass, as a drink must.

local lamp = param("lamp", 0.05) -- its radius
local level = param("level", 0.95) -- height of the tea; the inside goes from 0.14 to 1.3

-- The glass: a cone, rounded at the lip.
local function tumbler(bottom, radius, top, radius2)
  return cone { from = { 0, 0, bottom }, to = { 0, 0, top }, radius = radius, radius2 = radius2 }
end

local wall = tumbler(0, 0.52, 1.3, 0.66) - tumbler(0.14, 0.475, 1.31, 0.601)
  + torus { center = { 0, 0, 1.3 }, major_radius = 0.63, minor_radius = 0.03 }
local tea = tumbler(0.12, 0.495, 1.3, 0.63) & half_space { point = { 0, 0, level } }

-- The lens, and the block that holds it. It leans back towards the lamp.
local half, apart = 0.7, 1.15 -- radius where its balls meet; from their middles to that plane
local ball_radius = math.sqrt(half ^ 2 + apart ^ 2)
local lens = (sphere { center = { 0, -apart, 0 }, radius = ball_radius }
  & sphere { center = { 0, apart, 0 }, radius = ball_radius })
  :rotate { x = 16 }:translate { z = 0.78 }
local block = box { min = { -0.38, -0.3, 0 }, max = { 0.38, 0.3, 0.26 } } - lens

local table_top = wood { "#d9bd94", "#c9a677" }:rotate { x = 4, y = 87 }:scale(0.14)

return scene {
  unit = "dm",
  camera = perspective {
    from = { 0, -7.6, 5.6 }, at = { 0.3, -0.28, 0.3 }, fov = 27, aperture = 0.04,
  },
  lights = {
    sphere_light {
      center = { -3.6, 5.6, 5.4 }, radius = lamp, power = 34, color = { 1, 0.86, 0.7 },
    },
    environment { color = { 0.12, 0.14, 0.18 } },
  },
  objects = {
    group {
      wall:material(glass "N-BK7"):priority(2):name "glass",
      tea:material(glass { "water", color = "#d9862b", distance = 0.9 }):priority(1):name "tea",
    }:translate { 0.05, 0.55, 0 },
    sphere { center = { -1.35, -0.15, 0.48 }, radius = 0.48, material = glass "N-BK7" }:name "ball",
    group {
      lens:material(glass "N-BK7"):name "lens",
      block:material(matte "#2f4a46"):name "block",
    }:rotate { z = 33 }:translate { 1.5, 0.2, 0 },
    plane { material = matte(table_top), name = "table" },
  },
  render = { size = { 800, 600 }, samples = 192, max_depth = 16 },
}
