-- Carved from one block: a frame, three shells and a ball, one inside the other, cut out of a
-- single block of wood by balls and 36 cones. The wood is a pattern in space: its rings go on
-- through every cut.

local cos, sin, pi, sqrt = math.cos, math.sin, math.pi, math.sqrt

--- The directions of an icosahedron's corners: twelve holes for a shell.
local function corners()
  local g = (1 + sqrt(5)) / 2
  local n = sqrt(1 + g * g)
  local list = {}
  for _, s in ipairs { 1, -1 } do
    for _, t in ipairs { g, -g } do
      list[#list + 1] = { 0, s / n, t / n }
      list[#list + 1] = { s / n, t / n, 0 }
      list[#list + 1] = { t / n, 0, s / n }
    end
  end
  return list
end

local function ball(radius) return sphere { radius = radius } end

--- A shell with round holes that widen outwards.
local function shell(outer, inner, hole)
  local holes = {}
  for i, d in ipairs(corners()) do
    holes[i] = cone {
      from = { 0, 0, 0 }, to = { 1.5 * d[1] * outer, 1.5 * d[2] * outer, 1.5 * d[3] * outer },
      radius = 0, radius2 = 1.5 * outer * hole,
    }
  end
  return ball(outer) - ball(inner) - union(holes)
end

-- The frame: a cube with a little taken off its edges, opened by a ball.
local block = box { size = { 2.2, 2.2, 2.2 } } & sphere { radius = 1.8 }
local frame = block - ball(1.44)

local carving = union {
  frame,
  shell(1.09, 0.99, 0.4):rotate { z = -12 },
  shell(0.84, 0.75, 0.38):rotate { x = 12, z = -4 },
  shell(0.6, 0.52, 0.36):rotate { x = -14, y = 8, z = -20 },
  ball(0.34),
}

local timber = wood { colors = { "#e6c08c", "#d6a86c", "#b4814a", "#935f30" }, grain = 0.3 }
  :scale(0.085):rotate { x = 12, y = 9 }:translate { -0.9, 0.6, 0 }

local function softbox(center, size, radiance)
  return rectangle_light {
    center = center, size = size, at = { 0, 0, 1 }, radiance = radiance, name = "softbox",
  }
end

return scene {
  camera = perspective { from = { 0, -10, 5.2 }, at = { 0, 0, 1.02 }, fov = 19, fov_axis = "y" },
  lights = {
    softbox({ -5, -7, 6 }, { 5, 5 }, { 7.6, 7.1, 6.4 }),
    softbox({ 7, -1, 3 }, { 4, 5 }, { 2.2, 2.6, 3.2 }),
    softbox({ 0, 7, 6 }, { 8, 3 }, { 4, 4, 4 }),
    environment { color = { 0.3, 0.3, 0.32 } },
  },
  objects = {
    carving:material(matte(timber)):rotate { z = 33 }:translate { z = 1.1 }:name "carving",
    plane { material = matte "#8f877c", name = "table" },
  },
  render = { size = { 640, 400 }, samples = 96 },
  film = { exposure = 1.1 },
}
