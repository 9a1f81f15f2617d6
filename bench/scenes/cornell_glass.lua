-- A Cornell box with a ball of glass and a matte one under a small bright lamp: the geometry, light
-- and camera that error is compared on between renderers.

local white = matte { color = { 0.725, 0.71, 0.68 } }
local red = matte { color = { 0.63, 0.065, 0.05 } }
local green = matte { color = { 0.14, 0.45, 0.091 } }

local function wall(corner, u, v, material)
  return rectangle { corner = corner, edge_u = u, edge_v = v, material = material }
end

return scene {
  camera = perspective { from = { 0, -3.9, 1 }, at = { 0, 0, 1 }, fov = 38 },
  lights = {
    rectangle_light {
      corner = { -0.25, -0.25, 1.98 }, edge_u = { 0, 0.5, 0 }, edge_v = { 0.5, 0, 0 },
      radiance = { 15, 15, 15 },
    },
  },
  objects = {
    wall({ -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, white),
    wall({ -1, -1, 2 }, { 0, 2, 0 }, { 2, 0, 0 }, white),
    wall({ -1, 1, 0 }, { 2, 0, 0 }, { 0, 0, 2 }, white),
    wall({ -1, -1, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, red),
    wall({ 1, -1, 0 }, { 0, 0, 2 }, { 0, 2, 0 }, green),
    sphere { center = { 0.42, -0.35, 0.4 }, radius = 0.4, material = glass { ior = 1.5 } },
    sphere { center = { -0.42, 0.3, 0.4 }, radius = 0.4, material = matte { color = { 0.6, 0.6, 0.6 } } },
  },
  render = { size = { 256, 256 }, samples = 64, max_depth = 8, filter = "box" },
}
