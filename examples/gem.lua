-- Gem: a round brilliant with its 57 facets, from the proportions jewellers state, and the fire it
-- throws on what it lies on.
--
--   lapidary render gem.lua
--   lapidary render gem.lua --set pavilion=38        too flat: a dull ring, a fish eye
--   lapidary render gem.lua --set stone=N-BK7        the same of window glass
--   lapidary render gem.lua --set "lamp={0, 10, 6}"  lit from behind
--
-- A facet is ground by holding the stone against a wheel: it takes away all that is on the far side
-- of a plane. So the stone is what lies below 57 planes and in a round bar, its girdle. Three
-- corners are enough to know a plane, and those follow from the proportions.
--
-- Fire is dispersion of small bright lights. A narrow spot, all of it on the stone, comes out again
-- in hundreds of beams, which the facets have drawn out into colours; small panels, and the dark
-- between them, show in the facets themselves.

local stone = param("stone", "diamond")  -- a glass that `lapidary help glass` lists
local lamp = param("lamp", { -9, 2, 4 }) -- where the spot is

-- Degrees between facets and girdle; the others are shares of the girdle's radius or, for
-- the lengths of facets, of the way they have between table and girdle or girdle and culet.
local crown, pavilion = param("crown", 34.5), param("pavilion", 40.75)
local table_size, girdle, star, lower = 0.53, 0.06, 0.5, 0.77

local rad, cos, sin, tan, pi = math.rad, math.cos, math.sin, math.tan, math.pi

local function minus(a, b) return { a[1] - b[1], a[2] - b[2], a[3] - b[3] } end

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

--- The plane through three corners, counter-clockwise seen from outside.
local function facet(a, b, c)
  return { point = a, normal = cross(minus(b, a), minus(c, a)) }
end

--- A corner by its distance from the axis and its direction, in sixteenths of a turn.
local function corner(radius, sixteenth, z)
  return { radius * cos(sixteenth * pi / 8), radius * sin(sixteenth * pi / 8), z }
end

--- A round brilliant of radius 1 around the z axis, its table up, z = 0 halfway up its girdle.
local function brilliant()
  local top, bottom = girdle / 2, -girdle / 2
  -- Heights of the main facets, on the middle line and on the edge between two of them.
  local function crown_z(r) return top + (1 - r) * tan(rad(crown)) end
  local function pavilion_z(r) return bottom - (1 - r) * tan(rad(pavilion)) end
  local edge = cos(pi / 8)

  local table_z = crown_z(table_size)
  local star_radius = table_size * edge + star * (1 - table_size * edge)
  local star_z = crown_z(star_radius * edge)
  local lower_radius = 1 - lower
  local lower_z = pavilion_z(lower_radius * edge)

  local facets = { { point = { 0, 0, table_z }, normal = { 0, 0, 1 } } } -- the table
  local function cut(...) facets[#facets + 1] = facet(...) end
  for main = 0, 14, 2 do -- sixteenths of a turn
    local function above(i) return corner(1, main + i, top) end
    local function below(i) return corner(1, main + i, bottom) end
    local here, next = corner(table_size, main, table_z), corner(table_size, main + 2, table_z)
    local before, tip = corner(star_radius, main - 1, star_z), corner(star_radius, main + 1, star_z)
    local left = corner(lower_radius, main - 1, lower_z)
    local right = corner(lower_radius, main + 1, lower_z)

    cut(here, tip, next)                 -- star
    cut(before, above(0), tip)           -- crown main
    cut(above(0), above(1), tip)         -- upper girdle
    cut(above(1), above(2), tip)
    cut(below(0), left, right)     -- pavilion main
    cut(below(1), below(0), right)        -- lower girdle
    cut(below(2), below(1), right)
  end
  assert(#facets == 57)
  return polyhedron { planes = facets }
    & cylinder { from = { 0, 0, -2 }, to = { 0, 0, 2 }, radius = 1 }
end

--- Turns a brilliant so that it rests on a main facet of its pavilion.
local function at_rest(gem, turn)
  local height = (girdle / 2 + tan(rad(pavilion))) * cos(rad(pavilion))
  return gem:rotate { y = pavilion, z = turn }:translate { z = height }
end

--- Small panels on a dome, spread like the seeds of a sunflower; none of them where the table of
--- the stone would show its mirror image to the camera.
local function panels(count, distance)
  local list, golden = {}, pi * (3 - math.sqrt(5))
  for i = 1, count do
    local z = 0.15 + 0.85 * (i - 0.5) / count
    local r, angle = math.sqrt(1 - z * z), i * golden
    local x, y = r * cos(angle), r * sin(angle)
    if not (y < 0 and z > 0.75 and math.abs(x) < 0.3) then
      list[#list + 1] = rectangle_light {
        center = { distance * x, distance * y, distance * z }, size = { 0.8, 0.8 },
        at = { 0, 0, 0 }, radiance = 6, name = "panel",
      }
    end
  end
  return list
end

return scene {
  camera = perspective {
    from = { 0, -8.6, 6.6 }, at = { 0, -0.45, 0.3 }, fov = 27,
    aperture = 0.05, focus = { 0, -0.6, 0.9 },
  },
  lights = {
    spot_light { from = lamp, at = { 0, 0.22, 0.72 }, angle = 5, penumbra = 0.1, intensity = 2300 },
    panels(60, 14),
    environment { color = { 0.02, 0.024, 0.03 } },
  },
  objects = {
    at_rest(brilliant(), -90 + param("turn", 6)):material(glass(stone)):name "stone",
    plane { material = matte { color = { 0.55, 0.55, 0.56 } }, name = "ground" },
  },
  render = { size = { 800, 640 }, samples = 192, max_depth = 24 },
}
