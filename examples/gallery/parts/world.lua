-- The map that ../sphere_mapping.lua wraps around things, a world nobody has been to:
--
--   lapidary render world.lua -o world.jpg
--
-- Clouds of noise fill space, so what a sphere cuts out of them has neither seam nor poles. A
-- panorama from its middle is the map, by longitude and latitude; a lamp in the same place shines
-- evenly on all of it, and direct light alone shows the plain colours.

local height = fbm { octaves = 10, gain = 0.55, seed = param("seed", 5) }:scale(0.85)
local pole = max(
  luminance(gradient { colors = { { 0.8, 0 }, { 1, 1 } }, axis = { 0, 0, 1 } }),
  luminance(gradient { colors = { { 0.8, 0 }, { 1, 1 } }, axis = { 0, 0, -1 } }))

local world = ramp {
  height + 0.5 * pole, -- ice grows from the poles
  colors = {
    { 0.20, "#0f3354" }, { 0.47, "#2a678f" }, { 0.508, "#79b2bd" }, { 0.512, "#d8c58e" },
    { 0.55, "#86a052" }, { 0.68, "#4c7038" }, { 0.82, "#8d734c" }, { 0.92, "#c9b79a" },
    { 0.98, "#f6f4ef" },
  },
}

return scene {
  camera = panorama { from = { 0, 0, 0 }, at = { 0, 1, 0 } },
  lights = { point_light { position = { 0, 0, 0 }, intensity = math.pi } },
  objects = { sphere { radius = 2 } - sphere { radius = 1 }:material(matte(world)) },
  render = { size = { 1200, 600 }, samples = 16, integrator = "direct" },
  film = { tone = "none" },
}
