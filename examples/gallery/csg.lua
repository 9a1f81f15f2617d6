-- Union, intersection, difference: one box and one ball, joined, intersected and cut: a + b, a & b,
-- a - b. Where the box is cut it wears the colour of the ball that cut it.
local studio = require "parts.studio"

local a = box { size = { 1.4, 1.4, 1.4 } }:material(matte "#2b6a8a")
local b = sphere { radius = 0.9 }:material(matte "#e39a2d")

--- Put on the floor, its middle `z` above it.
local function stand(solid, x, z) return solid:rotate { z = -32 }:translate { x, 0, z } end
local row = { stand(a + b, -2.45, 0.9), stand(a & b, 0, 0.7), stand(a - b, 2.45, 0.7) }

return scene {
  camera = perspective { from = { 0, -11, 4.6 }, at = { 0, 0, 0.82 }, fov = 23.5, fov_axis = "y" },
  lights = studio.lights(),
  objects = { row, studio.floor "#d9d4ca" },
  render = { size = studio.size, samples = 128 },
}
