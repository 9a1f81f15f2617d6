-- Coordinates of a triangle: a mesh without texture coordinates gets some for each triangle from
-- its edges, u = d1.(p - p1) / d1.d1 and v likewise: every triangle has the same four by four
-- squares (left). Normalised edges give lengths instead of shares (middle); dividing both by one
-- length squeezes v (right).
local studio = require "parts.studio"

local function minus(a, b) return { a[1] - b[1], a[2] - b[2], a[3] - b[3] } end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

--- A crystal: a small crown on a tall body, of triangles that share their corners.
local function triangles()
  local list, sides = {}, 7
  local function ring(i, radius, z, shift)
    local angle = 2 * math.pi * (i + shift) / sides
    return { radius * math.cos(angle), radius * math.sin(angle), z }
  end
  local top = { 0, 0, 2.5 }
  for i = 0, sides - 1 do
    local a, b = ring(i, 0.62, 0, 0), ring(i + 1, 0.62, 0, 0)
    local c, d = ring(i, 0.95, 1.75, 0.5), ring(i + 1, 0.95, 1.75, 0.5)
    list[#list + 1] = { a, b, c }
    list[#list + 1] = { d, c, b }
    list[#list + 1] = { c, d, top }
  end
  return list
end


--- The edges normalised first, which is the same as dividing by a length once.
local function normalised(p, p1, d1, d2)
  local q = minus(p, p1)
  return { dot(d1, q) / math.sqrt(dot(d1, d1)), dot(d2, q) / math.sqrt(dot(d2, d2)) }
end

--- The right length for u, and the same for v.
local function one_length(p, p1, d1, d2)
  local q = minus(p, p1)
  return { dot(d1, q) / dot(d1, d1), dot(d2, q) / dot(d1, d1) }
end

--- The crystal with coordinates from a function, or with those the mesh makes for itself.
local function crystal(uv)
  local vertices, faces, uvs = {}, {}, uv and {}
  for _, t in ipairs(triangles()) do
    local n = #vertices
    faces[#faces + 1] = { n + 1, n + 2, n + 3 }
    for _, p in ipairs(t) do
      vertices[#vertices + 1] = p
      if uv then uvs[#uvs + 1] = uv(p, t[1], minus(t[2], t[1]), minus(t[3], t[1])) end
    end
  end
  return mesh { vertices = vertices, faces = faces, uvs = uvs, shading = "flat" }
end

local function pattern(dark)
  return matte(checker { colors = { "#efe6d2", dark }, mapping = "uv" }:scale(1 / 4))
end

--- A large crystal and a small one.
local function pair(uv, dark, x)
  return group {
    crystal(uv):rotate { z = 10 },
    crystal(uv):rotate { z = 31 }:scale(0.45):translate { 0.35, -1.5, 0 },
  }:material(pattern(dark)):translate { x, 0, 0 }
end

return scene {
  camera = perspective { from = { 0, -12, 4.6 }, at = { 0, -0.2, 1.0 }, fov = 22, fov_axis = "y" },
  lights = studio.lights(),
  objects = {
    pair(nil, "#1f6f63", -2.5), pair(normalised, "#a33b2a", 0), pair(one_length, "#a33b2a", 2.5),
    studio.floor "#8f9499",
  },
  render = { size = studio.size, samples = 128 },
}
