-- A map on what is no ball: one map of a world, by longitude and latitude about the middle, on a
-- ball and on two meshes that are none. Meridians and parallels bend to the shapes, and the seam of
-- the map does not show.
local studio = require "parts.studio"
local surfaces = require "parts.surfaces"

local cos, sin, abs = math.cos, math.sin, math.abs

--- Lines of the map across `axis`, where that begins and ends, again and again.
local function lines(axis)
  local profile = { { 0, 1 }, { 0.03, 1 }, { 0.05, 0 }, { 0.95, 0 }, { 0.97, 1 }, { 1, 1 } }
  return luminance(gradient {
    axis = axis, wrap = "repeat", colors = profile, mapping = "spherical",
  })
end

local world = image { param("map", "parts/world.jpg"), mapping = "spherical" }
local graticule = max(lines { 1 / 24, 0, 0 }, lines { 0, 1 / 12, 0 }) -- 15 degrees apart
local map = matte(mix(world, "#fbf6e8", 0.5 * graticule))

--- A cube with soft edges, and a bean of five lobes.
local function cube(theta, phi)
  local x, y, z = cos(phi) * cos(theta), cos(phi) * sin(theta), sin(phi)
  return 0.82 * (x ^ 6 + y ^ 6 + z ^ 6) ^ (-1 / 6)
end
local function lobes(theta, phi)
  return 0.86 + 0.2 * cos(5 * theta) * cos(phi) ^ 3 - 0.1 * abs(sin(phi)) ^ 3
end

local shapes = {
  sphere { radius = 0.92 },
  surfaces.star(cube, 240, 120):rotate { z = 12 },
  surfaces.star(lobes, 240, 120):rotate { x = 28 },
}

local row = {}
for i, shape in ipairs(shapes) do
  row[i] = shape:material(map):rotate { z = -100 }:rotate { x = 14, y = 8 }
    :translate { 2.35 * (i - 2), 0, 1.12 }
end
for i = -1, 1 do
  row[#row + 1] = torus { center = { 2.35 * i, 0, 0.09 }, major_radius = 0.46, minor_radius = 0.09 }
    :material(metal { "gold", roughness = 0.25 })
end

return scene {
  camera = perspective { from = { 0, -11, 3.4 }, at = { 0, 0, 0.98 }, fov = 23, fov_axis = "y" },
  lights = studio.lights(),
  objects = { row, studio.floor "#8a7a6c" },
  render = { size = studio.size, samples = 96 },
}
