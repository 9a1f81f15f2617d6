-- A wrinkled ball of a million triangles, which `write_blob` writes, over a floor, under a lamp and
-- a sky.

local blob = mesh { file = param "mesh", up = "z" }

local floor = rectangle { corner = { -20, -20, -1.1 }, edge_u = { 40, 0, 0 }, edge_v = { 0, 40, 0 } }

return scene {
  camera = perspective { from = { 0, -4, 1.2 }, at = { 0, 0, 0 }, fov = 40 },
  lights = {
    environment { color = { 0.4, 0.45, 0.5 } },
    sphere_light { center = { 2, -2, 4 }, radius = 0.5, radiance = { 12, 11, 10 } },
  },
  objects = {
    blob:material(matte { color = { 0.7, 0.4, 0.3 } }),
    floor:material(matte { color = { 0.5, 0.5, 0.5 } }),
  },
  render = { size = { 800, 600 }, samples = 16, max_depth = 5, filter = "box" },
}
