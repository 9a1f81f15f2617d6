-- The Cornell box, two units wide, with a tall block and a ball of glass under a square lamp.
--
--   lapidary render cornell.lua                     with the glass ball
--   lapidary render cornell.lua --set diffuse=true  with a matte one

local white = matte { color = { 0.73, 0.73, 0.73 } }
local red = matte { color = { 0.65, 0.05, 0.05 } }
local green = matte { color = { 0.12, 0.45, 0.15 } }

-- A wall from a corner and two edges; its front is the side where the edges turn left.
local function wall(corner, u, v, material)
  return rectangle { corner = corner, edge_u = u, edge_v = v, material = material }
end

local room = {
  wall({ -1, -1, -1 }, { 2, 0, 0 }, { 0, 2, 0 }, white):name "floor",
  wall({ -1, -1, 1 }, { 0, 2, 0 }, { 2, 0, 0 }, white):name "ceiling",
  wall({ -1, 1, -1 }, { 2, 0, 0 }, { 0, 0, 2 }, white):name "back wall",
  wall({ -1, -1, -1 }, { 0, 2, 0 }, { 0, 0, 2 }, red):name "left wall",
  wall({ 1, -1, -1 }, { 0, 0, 2 }, { 0, 2, 0 }, green):name "right wall",
}

local block = box { size = { 0.6, 0.6, 1.2 } }
  :rotate { z = math.deg(0.3) }
  :translate { -0.35, 0.35, -0.4 }
  :material(white)
  :name "block"

local ball = sphere { center = { 0.4, -0.25, -0.62 }, radius = 0.38 }
  :material(param("diffuse", false) and white or glass { ior = 1.5 })
  :name "ball"

return scene {
  camera = perspective { from = { 0, -3.9, 0 }, at = { 0, 0, 0 }, fov = 39 },
  lights = {
    rectangle_light {
      corner = { -0.25, -0.25, 0.98 }, edge_u = { 0, 0.5, 0 }, edge_v = { 0.5, 0, 0 },
      power = 12, color = { 1, 1, 1 },
    },
  },
  objects = { room, block, ball },
  render = { size = { 512, 512 }, samples = 512, max_depth = 8 },
}
