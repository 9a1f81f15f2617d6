-- A room whose floor and walls wear large pictures, or where `pictures` is not set the constant
-- colours that these have on average: all that differs is what it costs to look at them.

local pictures = param("pictures", "")

local function worn(name)
  if pictures == "" then return matte { color = param(name, "#808080") } end
  return matte { color = image { file = pictures .. "/" .. name .. ".png" } }
end

local function wall(corner, u, v, material)
  return rectangle { corner = corner, edge_u = u, edge_v = v, material = material }
end

return scene {
  camera = perspective { from = { 0, -3.9, 0 }, at = { 0, 0, 0 }, fov = 39 },
  lights = {
    rectangle_light {
      corner = { -0.25, -0.25, 0.98 }, edge_u = { 0, 0.5, 0 }, edge_v = { 0.5, 0, 0 }, power = 12,
    },
  },
  objects = {
    wall({ -1, -1, -1 }, { 2, 0, 0 }, { 0, 2, 0 }, worn "floor"),
    wall({ -1, -1, 1 }, { 0, 2, 0 }, { 2, 0, 0 }, matte { color = { 0.7, 0.7, 0.7 } }),
    wall({ -1, 1, -1 }, { 2, 0, 0 }, { 0, 0, 2 }, worn "back"),
    wall({ -1, -1, -1 }, { 0, 2, 0 }, { 0, 0, 2 }, worn "left"),
    wall({ 1, -1, -1 }, { 0, 0, 2 }, { 0, 2, 0 }, worn "right"),
  },
  render = { size = { 384, 384 }, samples = 16, max_depth = 8 },
}
