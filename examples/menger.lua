-- Menger: a sponge of holes within holes, cut open across a corner, with a lamp in its heart.
--
--   lapidary render menger.lua
--   lapidary render menger.lua --set level=4         1755 bars instead of 219
--   lapidary render menger.lua --set whole=true      not cut open
--
-- One cube and one list of square bars that it loses. Bars share faces and edges with each other,
-- and all of them end exactly in the faces of the cube; nothing of this needs care. The plane of
-- the cut is another solid, and the cut wears what that solid wears: all the six-pointed stars lie
-- in it, though nothing here is a star.

local level = param("level", 3)
local whole = param("whole", false)

-- Turns the axes among each other, to get from bars along z to bars along x and y.
local turns = {
  function(u, v, w) return { u, v, w } end,
  function(u, v, w) return { w, u, v } end,
  function(u, v, w) return { v, w, u } end,
}

--- Adds the bars through the middle of a square around {u, v}, and of its eight neighbours on
--- each level below. What is in the middle of a square is gone already.
local function drill(bars, u, v, side, depth)
  if depth == 0 then return end
  local third = side / 3
  for _, turn in ipairs(turns) do
    bars[#bars + 1] = box {
      min = turn(u - third / 2, v - third / 2, -1), max = turn(u + third / 2, v + third / 2, 1),
    }
  end
  for i = -1, 1 do
    for j = -1, 1 do
      if i ~= 0 or j ~= 0 then
        drill(bars, u + i * third, v + j * third, third, depth - 1)
      end
    end
  end
end

local bars = {}
drill(bars, 0, 0, 2, level)
local sponge = difference { box { size = { 2, 2, 2 } }, bars }:material(matte "#d8d2c8")

if not whole then
  -- All that is beyond the plane through the middle, square to the space diagonal.
  local beyond = half_space { normal = { -1, 1, -1 }, material = matte "#d8892b" }
  sponge = sponge:section(beyond)
end

return scene {
  camera = perspective { from = { 3.0, -8.2, 4.6 }, at = { 0, 0, -0.1 }, fov = 19.5 },
  lights = {
    sphere_light { radius = 0.14, power = 44, temperature = 2600, name = "heart" },
    rectangle_light {
      center = { -3, -6, 7 }, size = { 6, 6 }, at = { 0, 0, 0 }, radiance = { 2.4, 2.7, 3.1 },
    },
    environment { color = { 0.24, 0.28, 0.36 } },
  },
  objects = {
    sponge:name "sponge",
    plane { point = { 0, 0, -1 }, material = matte "#3b4450", name = "floor" },
  },
  render = { size = { 720, 720 }, samples = 160 },
}
