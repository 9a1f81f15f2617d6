-- A wall of a gallery under three downlights, whose light falls as their profile says: each is half
-- as bright as the one before it.

local wall = matte { color = "#d9d2c5" }

local lamps = {}
for i = 0, 2 do
  lamps[#lamps + 1] = point_light {
    position = { 1.4 * i - 1.4, -0.45, 2.9 }, profile = "downlight.ies",
    lumens = 600 / 2 ^ i, temperature = 3000,
  }
end

return scene {
  camera = perspective { from = { 0.6, -5.6, 1.6 }, at = { 0, 0, 1.45 }, fov = 34 },
  lights = lamps,
  objects = {
    plane { material = matte { color = "#6b4a34" } },
    box { min = { -4, 0, 0 }, max = { 4, 0.2, 3.2 }, material = wall },
    sphere { center = { -1.4, -0.5, 1.1 }, radius = 0.25, material = metal "gold" },
    box { min = { -1.6, -0.7, 0 }, max = { -1.2, -0.3, 0.85 }, material = wall },
    torus { center = { 0, -0.5, 1.12 }, axis = { 1, 1, 0.3 }, major_radius = 0.2, minor_radius = 0.07,
      material = matte { color = "#2f6f73" } },
    box { min = { -0.2, -0.7, 0 }, max = { 0.2, -0.3, 0.85 }, material = wall },
    sphere { center = { 1.4, -0.5, 1.1 }, radius = 0.25, material = matte { color = "#b0402c" } },
    box { min = { 1.2, -0.7, 0 }, max = { 1.6, -0.3, 0.85 }, material = wall },
  },
  render = { size = { 960, 540 }, samples = 256, max_depth = 6 },
  film = { exposure = 4 },
}
