-- One ball of each pattern, on bricks and tiles. Patterns in space go through the whole solid: see
-- the slice of the wooden one.
local patterns = {
  wood {}:rotate { x = 80, y = 10 }:scale(0.12),
  marble {}:rotate { z = 30 }:scale(0.7),
  fbm { colors = { { 0.3, "#1d3f6e" }, { 0.5, "#dfe8f0" }, { 0.7, "#ffffff" } } }:scale(0.5),
  turbulence { "#180400", "#a02000", "#ffa020", "#fff0b0" }:scale(0.6),
  voronoi { colors = { "#5a4632", "#b59a72", "#d8c7a4" }, feature = "cells" }:scale(0.2)
    * clamp(voronoi { feature = "edges" }:scale(0.2) * 8, 0.15, 1),
  checker { "#e8e2d4", "#7b2d26" }:scale(0.25),
  gradient { axis = { 0, 0, 1 }, colors = { "#d7263d", "#f4a259", "#3a7d8c" } }:translate { z = -0.5 },
  mix("#c9b48a", wood {}:scale(0.05), ramp { fbm {}:scale(0.4), from = 0.45, to = 0.55 }),
}

local balls = {}
for i, pattern in ipairs(patterns) do
  local column, row = (i - 1) % 4, (i - 1) // 4
  local ball = sphere { radius = 0.5 }
  if i == 1 then ball = ball - box { min = { -1, -1, -1 }, max = { 0.1, -0.1, 1 } } end
  balls[i] = ball:material(matte(pattern)):translate { 1.25 * (column - 1.5), 1.3 * row, 0.5 }
end

local tiles = grid { colors = { "#b9b4a8", "#6f6a60" }, width = 0.03 }:scale(0.5)
  * (0.75 + 0.25 * fbm {})

return scene {
  camera = perspective { from = { 0, -6.5, 2.7 }, at = { 0, 0.7, 0.55 }, fov = 30 },
  lights = {
    environment { color = "#8ea6c0" },
    sphere_light { center = { -4, -5, 6 }, radius = 1, power = 900 },
  },
  objects = {
    balls,
    plane { material = matte(tiles) },
    box { min = { -6, 2.6, 0 }, max = { 6, 2.8, 3 }, material = matte(bricks {}) },
  },
  render = { size = { 960, 540 }, samples = 128 },
}
