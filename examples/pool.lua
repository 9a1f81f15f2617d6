-- Pool: the sun writes the waves of the water on the tiles below it.
--
--   lapidary render pool.lua
--   lapidary render pool.lua --set waves=0.4         nearly calm: soft lines
--   lapidary render pool.lua --set waves=2           a windy day
--   lapidary render pool.lua --set elevation=25      in the evening
--
-- Crests gather light like lenses and troughs spread it. The water is a body like any other: a mesh
-- that is wavy on top and reaches a little into the walls, so that there is no gap; where ball and
-- rail dip into it, it ends. The pool itself is ground minus a box.

local waves = param("waves", 1)          -- height of the waves, as a multiple
local elevation = param("elevation", 52) -- of the sun
local wide, long, depth = 4.4, 6, 1.25   -- of the pool, in metres

-- Numbers that look random and stay the same.
local seed = 11
local function random()
  seed = (seed * 16807) % 2147483647
  return seed / 2147483647
end

-- Waves from everywhere, but more along x; the shorter, the lower.
local trains = {}
for i = 1, 14 do
  local length = 0.5 * 1.16 ^ (i - 5)
  local angle = 3.6 * (random() - 0.5)
  local k = 2 * math.pi / length
  trains[i] = {
    k * math.cos(angle), k * math.sin(angle), 2 * math.pi * random(), 0.008 * length,
  }
end

local function height(x, y)
  local z = 0
  for _, t in ipairs(trains) do z = z + t[4] * math.sin(t[1] * x + t[2] * y + t[3]) end
  return waves * z
end

--- A body from the floor of the pool up to the waves, 5 cm larger than the pool all around.
local function water(step)
  local w, l = wide + 0.1, long + 0.1
  local columns, rows = math.ceil(w / step), math.ceil(l / step)
  local vertices, faces = {}, {}
  for _, top in ipairs { true, false } do
    for j = 0, rows do
      for i = 0, columns do
        local x, y = w * (i / columns - 0.5), l * (j / rows - 0.5)
        vertices[#vertices + 1] = { x, y, top and height(x, y) or -depth - 0.05 }
      end
    end
  end
  local below = (columns + 1) * (rows + 1)
  local function corner(i, j) return j * (columns + 1) + i + 1 end
  for j = 1, rows do
    for i = 1, columns do
      local a, b, c, d = corner(i - 1, j - 1), corner(i, j - 1), corner(i, j), corner(i - 1, j)
      faces[#faces + 1] = { a, b, c, d }
      faces[#faces + 1] = { below + d, below + c, below + b, below + a }
    end
  end
  local function side(a, b) faces[#faces + 1] = { below + a, below + b, b, a } end
  for i = 1, columns do
    side(corner(i - 1, 0), corner(i, 0))
    side(corner(i, rows), corner(i - 1, rows))
  end
  for j = 1, rows do
    side(corner(columns, j - 1), corner(columns, j))
    side(corner(0, j), corner(0, j - 1))
  end
  return mesh { vertices = vertices, faces = faces }
end

-- The pool: small tiles inside, slabs around it. Cut faces wear what their cutter wears.
local tiles = grid { colors = { "#7fc4d4", "#eef6f6" }, width = 0.06 }:scale(0.2)
local slabs = grid { colors = { "#d9cfbd", "#a89d8b" }, width = 0.015 }:scale(0.8)
local edge = 0.2 -- of the ground, over the water
local ground = half_space { point = { 0, 0, edge }, material = matte(slabs) } - box {
  min = { -wide / 2, -long / 2, -depth }, max = { wide / 2, long / 2, 1 }, material = matte(tiles),
}

-- A ladder of bent tubes.
local ladder = {}
for _, y in ipairs { -0.25, 0.25 } do
  local function tube(x, from, to)
    return cylinder { from = { x, y, from }, to = { x, y, to }, radius = 0.025 }
  end
  local bend = torus {
    center = { 0.2, y, 0.6 }, axis = { 0, 1, 0 }, major_radius = 0.35, minor_radius = 0.025,
  } & half_space { point = { 0, 0, 0.6 }, normal = { 0, 0, -1 } }
  ladder[#ladder + 1] = bend + tube(-0.15, -0.9, 0.6) + tube(0.55, edge - 0.1, 0.6)
end
for z = -0.8, 0.1, 0.28 do
  ladder[#ladder + 1] = cylinder {
    from = { -0.15, -0.25, z }, to = { -0.15, 0.25, z }, radius = 0.03,
  }
end

local stripes = checker { colors = { "#f4f1ea", "#d8402c" }, mapping = "uv" }:scale { 1 / 8, 2, 1 }

return scene {
  camera = perspective { from = { -1.6, -6.0, 3.9 }, at = { 0.2, -0.75, -0.35 }, fov = 33 },
  lights = {
    sun {
      from = { -0.75, 0.66, math.tan(math.rad(elevation)) }, angle = 0.53,
      irradiance = 3.6, color = { 1, 0.94, 0.84 },
    },
    environment { color = { 0.26, 0.4, 0.62 } },
  },
  objects = {
    ground:name "ground",
    water(0.04):material(glass { "water", color = "#b9e6e8", distance = 3 }):name "water",
    union(ladder):translate { wide / 2, 0.4, 0 }:material(metal { "silver", roughness = 0.15 })
      :name "ladder",
    sphere { radius = 0.28, material = matte(stripes) }:rotate { x = 35, y = 25 }
      :translate { -0.75, -1.1, 0.2 }:name "ball",
  },
  render = { size = { 800, 600 }, samples = 160, max_depth = 12 },
}
