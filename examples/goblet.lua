-- Goblet: glass, drink, ice and an olive, each said on its own, overlapping as they please.
--
--   lapidary render goblet.lua
--   lapidary render goblet.lua --set level=1.9       less to drink
--   lapidary render goblet.lua --set drink=#7a0c18   something stronger
--
-- To look right, a drink must touch its glass: with a gap there is air between them, with
-- a surface of its own there are two where there should be one. Here the drink reaches halfway into
-- the glass, the ice stands out of the drink, and where two of them overlap, the one of
-- greater priority is there. Each ray finds, at every surface, what it leaves and what it enters:
-- air to glass, glass to drink, drink to ice. Nobody has made these surfaces.

local level = param("level", 2.25) -- height of the drink; the bowl goes from 1.3 to 3

local clear = glass "N-BK7"
local drink = glass { ior = 1.345, color = param("drink", "#f08a1c"), distance = 1.1 }
local ice = glass(1.31)

-- The goblet: a ball without its inside and its top, on a stem with soft ends, on a foot.
local middle, outer, inner, rim = { 0, 0, 2.3 }, 1, 0.95, 3

local function ball(radius) return sphere { center = middle, radius = radius } end
local function below(z) return half_space { point = { 0, 0, z } } end

local function ring_radius(radius) return math.sqrt(radius ^ 2 - (rim - middle[3]) ^ 2) end
local wall = (ring_radius(outer) - ring_radius(inner)) / 2

local bowl = ball(outer) & below(rim)
local lip = torus {
  center = { 0, 0, rim }, major_radius = ring_radius(inner) + wall, minor_radius = wall,
}
local stem = cylinder { from = { 0, 0, 0.1 }, to = { 0, 0, 1.5 }, radius = 0.32 }
  - torus { center = { 0, 0, 0.72 }, major_radius = 0.74, minor_radius = 0.66 }
local foot = cone { from = { 0, 0, 0.04 }, to = { 0, 0, 0.2 }, radius = 0.82, radius2 = 0.2 }
  + cylinder { from = { 0, 0, 0 }, to = { 0, 0, 0.04 }, radius = 0.82 }
local goblet = (bowl + stem + foot - (ball(inner) & below(rim + 1)) + lip)

-- What is in it.
local filling = ball((outer + inner) / 2) & below(level)

local function cube(side)
  return box { size = { side, side, side } } & sphere { radius = 0.76 * side }
end

local olive = ellipsoid { radii = { 0.2, 0.2, 0.26 } }
local pit = cylinder { from = { 0, 0, 0.1 }, to = { 0, 0, 0.3 }, radius = 0.07 }
local pick = cylinder { from = { 0, 0, -0.5 }, to = { 0, 0, 1.65 }, radius = 0.018 }
local snack = group {
  (olive - pit):material(matte "#b5c24a"):name "olive",
  (olive & pit):material(matte "#b3261c"):name "pimento",
  pick:material(metal { "silver", roughness = 0.1 }):name "pick",
}

local function softbox(center, size, radiance)
  return rectangle_light {
    center = center, size = size, at = { 0, 0, 1.7 }, radiance = radiance, name = "softbox",
  }
end

return scene {
  unit = "cm",
  camera = perspective { from = { 0, -12, 3.3 }, at = { 0, 0, 1.66 }, fov = 19 },
  lights = {
    softbox({ 0, 9, 4 }, { 16, 9 }, { 0.66, 0.7, 0.77 }),
    softbox({ -7, -5, 6 }, { 7, 9 }, { 2.0, 1.9, 1.8 }),
    softbox({ 8, 0, 4 }, { 3, 8 }, { 1.8, 1.9, 2.0 }),
    environment { color = { 0.42, 0.43, 0.45 } },
  },
  objects = {
    goblet:material(clear):priority(3):name "goblet",
    filling:material(drink):priority(1):name "drink",
    cube(0.62):rotate { x = 24, y = 18, z = 30 }:translate { -0.36, -0.08, 2.2 }
      :material(ice):priority(2):name "ice",
    cube(0.56):rotate { x = -20, y = 32, z = 10 }:translate { 0.3, 0.3, 2.17 }
      :material(ice):priority(2):name "ice",
    snack:rotate { y = 34, z = -20 }:translate { 0.22, -0.4, 2.3 }:priority(2),
    plane { material = matte "#cfb28c", name = "table" },
  },
  render = { size = { 640, 800 }, samples = 256, max_depth = 24 },
}
