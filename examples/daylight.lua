-- Solids in the sun of a clear day. The light is as strong as in nature, so the exposure is small:
--
--   lapidary render daylight.lua --set elevation=60                          noon
--   lapidary render daylight.lua --set elevation=3 --render exposure=0.04      before sunset
--   lapidary render daylight.lua --set elevation=-3 --render exposure=1.5      dusk

local elevation = param("elevation", 25)

local stone = matte { color = "#cbb9a0" }
local arch = (box { min = { -1.6, -0.4, 0 }, max = { 1.6, 0.4, 2.4 } }
  - cylinder { from = { 0, -1, 1.1 }, to = { 0, 1, 1.1 }, radius = 0.9 }
  - box { min = { -0.9, -1, -1 }, max = { 0.9, 1, 1.1 } }):material(stone)

return scene {
  camera = perspective { from = { 5.5, -7.5, 1.9 }, at = { 0.1, 0, 1.15 }, fov = 32 },
  lights = { sky { elevation = elevation, azimuth = 250 } },
  objects = {
    plane { material = matte { color = { 0.2, 0.19, 0.17 } } },
    arch,
    sphere { center = { 2.4, -1, 0.6 }, radius = 0.6, material = glass "N-BK7" },
    sphere { center = { -2.4, -0.6, 0.7 }, radius = 0.7, material = metal "silver" },
    cone { from = { 1.1, -2.2, 0 }, to = { 1.1, -2.2, 0.8 }, radius = 0.4,
      material = matte { color = "#b03a2a" } },
  },
  render = { size = { 960, 540 }, samples = 256, max_depth = 10 },
  film = { exposure = 0.01 },
}
