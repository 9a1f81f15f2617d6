-- Meshes from formulas: a sheet of rows and columns, bent by a function of two numbers.
local surfaces = {}

local cos, sin, pi = math.cos, math.sin, math.pi

--- The mesh of f(u, v), which gives a point, for u and v from 0 to 1. With `around` the sheet
--- closes in u; its front is where u goes right and v goes up.
function surfaces.sheet(f, columns, rows, options)
  options = options or {}
  local width = options.around and columns or columns + 1
  local vertices, faces = {}, {}
  for j = 0, rows do
    for i = 0, width - 1 do vertices[#vertices + 1] = f(i / columns, j / rows) end
  end
  local function number(i, j) return j * width + i % width + 1 end
  for j = 0, rows - 1 do
    for i = 0, columns - 1 do
      faces[#faces + 1] = { number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1) }
    end
  end
  return mesh { vertices = vertices, faces = faces, shading = options.shading or "smooth" }
end

--- A closed mesh around the origin: at longitude theta and latitude phi, in radians, its surface
--- is r(theta, phi) away. The poles are fans of triangles.
function surfaces.star(r, columns, rows)
  local vertices, faces = {}, {}
  local function add(theta, phi)
    local d = r(theta, phi)
    vertices[#vertices + 1] = { d * cos(phi) * cos(theta), d * cos(phi) * sin(theta), d * sin(phi) }
  end
  add(0, -pi / 2)
  for j = 1, rows - 1 do
    for i = 0, columns - 1 do add(2 * pi * i / columns, pi * j / rows - pi / 2) end
  end
  add(0, pi / 2)

  local last = #vertices
  local function number(i, j) return (j - 1) * columns + i % columns + 2 end
  for i = 0, columns - 1 do
    faces[#faces + 1] = { 1, number(i + 1, 1), number(i, 1) }
    for j = 1, rows - 2 do
      faces[#faces + 1] = { number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1) }
    end
    faces[#faces + 1] = { number(i, rows - 1), number(i + 1, rows - 1), last }
  end
  return mesh { vertices = vertices, faces = faces, shading = "smooth" }
end

return surfaces
