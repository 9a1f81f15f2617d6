-- Lens: two balls make a burning glass; a ring of brass holds it over a sheet of squared paper.
--
--   lapidary render lens.lua
--   lapidary render lens.lua --set thickness=0.6     a stronger lens
--   lapidary render lens.lua --set glass=diamond     and one nobody could pay
--
-- What two balls have in common is a lens, round to the last digit: there are no facets to see
-- in the enlarged paper. The ring simply overlaps the lens; what is opaque goes before what is
-- clear, so the rim sits in its seat without a gap. The lines of the paper are bodies too, sunk
-- into the sheet: of all that overlap, the one of the greatest priority is there.

local thickness = param("thickness", 0.34)
local kind = param("glass", "N-BK7") -- a glass that `lapidary help glass` lists

-- Balls of a radius such that the lens has a radius of 1 where they meet.
local ball_radius = (1 + (thickness / 2) ^ 2) / thickness
local apart = ball_radius - thickness / 2

local lens = sphere { center = { 0, 0, -apart }, radius = ball_radius }
  & sphere { center = { 0, 0, apart }, radius = ball_radius }

local function bar(from, to, radius)
  return cylinder { from = from, to = to, radius = radius }
end

-- The ring, with a rounded inside that grips the lens, a neck and a turned handle.
local ring = bar({ 0, 0, -0.1 }, { 0, 0, 0.1 }, 1.03) - bar({ 0, 0, -1 }, { 0, 0, 1 }, 0.95)
  + torus { major_radius = 1.03, minor_radius = 0.1 }
local neck = bar({ 1.05, 0, 0 }, { 1.75, 0, 0 }, 0.09)
  + torus { center = { 1.5, 0, 0 }, axis = { 1, 0, 0 }, major_radius = 0.12, minor_radius = 0.06 }
local handle = cone { from = { 1.65, 0, 0 }, to = { 3.7, 0, 0 }, radius = 0.13, radius2 = 0.24 }
  + sphere { center = { 3.7, 0, 0 }, radius = 0.24 }
  - torus { center = { 1.95, 0, 0 }, axis = { 1, 0, 0 }, major_radius = 0.19, minor_radius = 0.04 }
  - torus { center = { 3.5, 0, 0 }, axis = { 1, 0, 0 }, major_radius = 0.26, minor_radius = 0.04 }

local magnifier = group {
  lens:material(glass(kind)):name "lens",
  (ring + neck):material(metal { "gold", roughness = 0.15 }):name "ring",
  handle:material(matte "#4a1d12"):name "handle",
}

--- Lines every tenth, heavier ones every fifth, in a sheet whose top is z = 0.
local function squared_paper(half_width, half_depth)
  local thin, thick = {}, {}
  local function line(i, along_x)
    local heavy = i % 5 == 0
    local w = heavy and 0.009 or 0.004
    local min = along_x and { -half_width, i / 10 - w, -0.01 } or { i / 10 - w, -half_depth, -0.01 }
    local max = along_x and { half_width, i / 10 + w, 0 } or { i / 10 + w, half_depth, 0 }
    local list = heavy and thick or thin
    list[#list + 1] = box { min = min, max = max }
  end
  for i = -10 * half_depth, 10 * half_depth do line(i, true) end
  for i = -10 * half_width, 10 * half_width do line(i, false) end
  return {
    box { min = { -half_width, -half_depth, -0.02 }, max = { half_width, half_depth, 0 } }
      :material(matte "#efe9dc"):name "paper",
    union(thin):material(matte "#7fa6bd"):priority(1):name "thin lines",
    union(thick):material(matte "#b4533c"):priority(2):name "heavy lines",
  }
end

return scene {
  unit = "cm",
  camera = perspective { from = { -0.8, -7, 10 }, at = { 0.35, -0.05, 0.35 }, fov = 20 },
  lights = {
    rectangle_light {
      center = { -6, 5, 9 }, size = { 12, 12 }, at = { 0, 0, 0 }, radiance = { 1.15, 1.1, 1.02 },
    },
    rectangle_light {
      center = { 8, -2, 5 }, size = { 3, 6 }, at = { 0, 0, 0 }, radiance = { 1.6, 1.7, 1.9 },
    },
    environment { color = { 0.58, 0.6, 0.63 } },
  },
  objects = {
    magnifier:rotate { x = 22, y = 10, z = -24 }:translate { -0.45, 0.1, 0.95 },
    group(squared_paper(3, 2)):rotate { z = 8 }:name "sheet",
    plane { point = { 0, 0, -0.02 }, material = matte "#3d4a48", name = "desk" },
  },
  render = { size = { 800, 500 }, samples = 192 },
}
