-- A lens of two balls throws a burning spot onto the floor from a small bright lamp: the geometry,
-- light and camera that caustics are compared on between renderers.
--
-- `radius` is that of the lamp; its power stays. Paths from the camera meet a lamp of 0.5 often
-- enough to check what is found otherwise; for 0.05 they hardly do.

local radius = param("radius", 0.05)
local radiance = 600 * (0.05 / radius) ^ 2

local function ball(z) return sphere { center = { 0, 0, z }, radius = 0.8 } end

return scene {
  camera = perspective { from = { 0, -2.6, 2.4 }, at = { 0, 0, 0.35 }, fov = 38 },
  lights = {
    sphere_light {
      center = { 0.25, 0, 3 }, radius = radius, radiance = { radiance, radiance, radiance },
    },
  },
  objects = {
    -- They meet at z = 1 in a circle of radius 0.4.
    (ball(0.307179677) & ball(1.69282032)):material(glass(1.5)):name "lens",
    rectangle {
      corner = { -6, -6, 0 }, edge_u = { 12, 0, 0 }, edge_v = { 0, 12, 0 },
      material = matte { color = { 0.6, 0.6, 0.6 } }, name = "floor",
    },
  },
  render = {
    size = { 400, 300 }, samples = 64, max_depth = 8, filter = "box",
    caustics = param("caustics", "auto"),
  },
}
