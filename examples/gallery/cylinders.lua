-- Cylinders and mushrooms: left solid cylinders, whose caps are flat. Right the same as meshes with
-- a classic mistake: caps with the normals of a ball about the middle, which makes mushrooms of
-- them.
local studio = require "parts.studio"

local cos, sin, sqrt, pi = math.cos, math.sin, math.sqrt, math.pi

local function solid(radius, height)
  return cylinder { from = { 0, 0, 0 }, to = { 0, 0, height }, radius = radius }
end

--- A cylinder as a mesh; the normals of its cap point away from a point inside, not up.
local function mushroom(radius, height)
  local vertices, normals, faces = {}, {}, {}
  local sides, rings = 96, 16
  local function ring(r, z, normal)
    for i = 0, sides - 1 do
      local x, y = cos(2 * pi * i / sides), sin(2 * pi * i / sides)
      vertices[#vertices + 1] = { r * x, r * y, z }
      normals[#normals + 1] = normal(x, y)
    end
  end
  local function side(x, y) return { x, y, 0 } end
  ring(radius, 0, side)
  ring(radius, height, side)
  for k = 0, rings - 1 do
    local r = radius * (1 - k / rings)
    local share = r / radius
    ring(r, height, function(x, y)
      return { share * x, share * y, sqrt(1.02 - share ^ 2) }
    end)
  end
  vertices[#vertices + 1], normals[#normals + 1] = { 0, 0, height }, { 0, 0, 1 }

  local function number(row, i) return row * sides + i % sides + 1 end
  local function quad(row, i)
    return { number(row, i), number(row, i + 1), number(row + 1, i + 1), number(row + 1, i) }
  end
  for i = 0, sides - 1 do
    faces[#faces + 1] = quad(0, i)                               -- of the side
    for row = 2, rings do faces[#faces + 1] = quad(row, i) end   -- of the cap
    faces[#faces + 1] = { number(rings + 1, i), number(rings + 1, i + 1), #vertices }
  end
  return mesh { vertices = vertices, faces = faces, normals = normals }
end

local copper = metal { "copper", roughness = 0.35 }
local gold = metal { "gold", roughness = 0.3 }
local steel = metal { color = "#6f9fb0", roughness = 0.35 }

--- Three of a kind.
local function set(make, x)
  return group {
    make(0.62, 1.5):material(copper):translate { -0.62, 0.5, 0 },
    make(0.5, 0.8):material(gold):translate { 0.62, 0.25, 0 },
    make(0.42, 0.4):material(steel):translate { -0.1, -0.75, 0 },
  }:translate { x, 0, 0 }
end

return scene {
  camera = perspective { from = { 0, -10, 6 }, at = { 0, 0, 0.62 }, fov = 21, fov_axis = "y" },
  lights = studio.lights(),
  objects = { set(solid, -1.55), set(mushroom, 1.55), studio.floor "#c9c3b8" },
  render = { size = studio.size, samples = 128 },
}
