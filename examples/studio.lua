-- Studio: a product on a plinth, softboxes around it, paper that sweeps up behind it.
--
--   lapidary render studio.lua                           three chessmen of gold
--   lapidary render studio.lua --set product=shell       a sea shell
--   lapidary render studio.lua --set product=flacon      a bottle of glass with a golden stopper
--   lapidary render studio.lua --set product=duck.obj    your own mesh, beside this file
--   lapidary render studio.lua --set metal=silver --set paper=#8fa3a8
--
-- A mesh comes as it is, upright. It fits when it is about 2 units high and {0, 0, 0} is in the
-- middle of its foot; --set scale=20 --set turn=90 --set "move={0, 0, -0.5}", in this order, help.
--
-- The chessmen are one metal in three finishes: polished, satin and brushed.

local product = param("product", "chess")
local kind = param("metal", "gold")
local paper = param("paper", "#dcc9b6")
local scale, turn, move = param("scale", 1), param("turn", 0), param("move", { 0, 0, 0 })

local cos, sin, exp, pi = math.cos, math.sin, math.exp, math.pi

-- Meshes ---------------------------------------------------------------------------------------

--- A surface over a grid: point(i, j) for i = 0 ... rows and j = 0 ... columns - 1, closed in j.
--- Its front is where rows go up when columns go to the right.
local function tube(rows, columns, point, shading)
  local vertices, faces = {}, {}
  for i = 0, rows do
    for j = 0, columns - 1 do vertices[#vertices + 1] = point(i, j) end
  end
  for i = 0, rows - 1 do
    for j = 0, columns - 1 do
      local a, b = i * columns + j + 1, i * columns + (j + 1) % columns + 1
      faces[#faces + 1] = { a, b, b + columns, a + columns }
    end
  end
  return mesh { vertices = vertices, faces = faces, shading = shading or "smooth" }
end

--- A smooth curve through points {r, z}, `count` steps between two of them (Catmull and Rom).
local function through(points, count)
  local curve = {}
  local function at(i) return points[math.max(1, math.min(#points, i))] end
  for i = 1, #points - 1 do
    local a, b, c, d = at(i - 1), at(i), at(i + 1), at(i + 2)
    for k = 0, count - 1 do
      local t, p = k / count, {}
      for n = 1, 2 do
        p[n] = b[n] + 0.5 * t * (c[n] - a[n]
          + t * (2 * a[n] - 5 * b[n] + 4 * c[n] - d[n] + t * (3 * (b[n] - c[n]) + d[n] - a[n])))
      end
      curve[#curve + 1] = p
    end
  end
  curve[#curve + 1] = points[#points]
  return curve
end

--- What a lathe makes of a profile {r, z} from the foot up; corners sharper than 30 degrees stay.
local function turned(profile)
  local curve, around = through(profile, 8), 96
  return tube(#curve - 1, around, function(i, j)
    local p, angle = curve[i + 1], 2 * pi * j / around
    return { math.max(p[1], 0) * cos(angle), math.max(p[1], 0) * sin(angle), p[2] }
  end)
end

-- Products -------------------------------------------------------------------------------------

local foot = {
  { 0, 0 }, { 0.36, 0 }, { 0.36, 0 }, { 0.39, 0.03 }, { 0.39, 0.1 }, { 0.34, 0.15 },
  { 0.33, 0.19 }, { 0.25, 0.26 },
}

local function chessman(more)
  local profile = { table.unpack(foot) }
  for _, p in ipairs(more) do profile[#profile + 1] = p end
  return turned(profile)
end

local function pawn()
  return chessman {
    { 0.16, 0.4 }, { 0.12, 0.6 }, { 0.12, 0.68 }, { 0.22, 0.72 }, { 0.22, 0.76 }, { 0.11, 0.8 },
    { 0.16, 0.86 }, { 0.21, 0.98 }, { 0.16, 1.11 }, { 0.08, 1.16 }, { 0, 1.17 },
  }
end

local function bishop()
  return chessman {
    { 0.17, 0.45 }, { 0.12, 0.75 }, { 0.11, 0.95 }, { 0.22, 1.0 }, { 0.22, 1.04 }, { 0.13, 1.08 },
    { 0.13, 1.12 }, { 0.2, 1.25 }, { 0.17, 1.42 }, { 0.06, 1.58 }, { 0.05, 1.61 }, { 0.085, 1.67 },
    { 0.05, 1.73 }, { 0, 1.74 },
  }
end

local function queen()
  return chessman {
    { 0.18, 0.5 }, { 0.13, 0.9 }, { 0.125, 1.2 }, { 0.25, 1.25 }, { 0.25, 1.3 }, { 0.14, 1.34 },
    { 0.14, 1.4 }, { 0.18, 1.6 }, { 0.26, 1.8 }, { 0.27, 1.82 }, { 0.24, 1.84 }, { 0.13, 1.88 },
    { 0.06, 1.92 }, { 0.09, 1.98 }, { 0.06, 2.04 }, { 0, 2.05 },
  }
end

local function finish(roughness) return metal { kind, roughness = roughness } end

local function chess()
  return {
    queen():material(finish(0.04)):translate { -0.75, 0.25, 0 }:name "queen",
    bishop():material(finish(0.2)):translate { 0.3, 0.3, 0 }:name "bishop",
    pawn():material(finish(0.35)):translate { 0.75, -0.6, 0 }:name "pawn",
  }
end

--- A tube that winds up and widens as a snail builds it, ribbed along its growth.
local function shell()
  local turns, per_turn, around = 7, 90, 72
  local rows = turns * per_turn
  return tube(rows, around, function(i, j)
    local angle = 2 * pi * i / per_turn
    local size = exp(0.085 * (angle - 2 * pi * turns))
    local v = 2 * pi * j / around
    local rib = 1 + 0.025 * sin(20 * v)
    local r = size * (0.62 + 0.56 * rib * cos(v))
    return { r * cos(angle), r * sin(angle), size * (-2.3 + 0.72 * rib * sin(v)) }
  end)
    :rotate { z = 160 }:rotate { y = 55 }:scale(0.85):translate { x = 0.85, z = 1.5 }
    :material(matte "#f1e4d6"):name "shell"
end

local function flacon()
  local bottle = turned {
    { 0, 0 }, { 0.55, 0 }, { 0.55, 0 }, { 0.72, 0.2 }, { 0.75, 0.6 }, { 0.6, 1.0 }, { 0.25, 1.2 },
    { 0.2, 1.3 }, { 0.2, 1.45 }, { 0.15, 1.47 }, { 0, 1.47 },
  }
  return {
    bottle:material(glass "N-BK7"):name "bottle",
    cylinder { from = { 0, 0, 1.48 }, to = { 0, 0, 1.62 }, radius = 0.24, material = finish(0.2) },
    sphere { center = { 0, 0, 1.85 }, radius = 0.26, material = finish(0.04) }:name "stopper",
  }
end

local products = { chess = chess, shell = shell, flacon = flacon }
local made = products[product]
local subject = made and made() or mesh(product):scale(scale):rotate { z = turn }:translate(move)

-- The studio -----------------------------------------------------------------------------------

--- Paper that lies on the floor and curves up into a wall.
local function sweep()
  local width, front, back, bend = 14, -5, 8, 6
  local profile = { { front, 0 }, { back - bend - 0.1, 0 }, { back - bend, 0 } }
  for i = 1, 63 do
    local angle = pi / 2 * i / 64
    profile[#profile + 1] = { back - bend + bend * sin(angle), bend - bend * cos(angle) }
  end
  profile[#profile + 1] = { back, bend }
  profile[#profile + 1] = { back, bend + 0.1 }
  profile[#profile + 1] = { back, 16 }
  local vertices, faces = {}, {}
  for i, p in ipairs(profile) do
    vertices[2 * i - 1] = { -width / 2, p[1], p[2] }
    vertices[2 * i] = { width / 2, p[1], p[2] }
    if i > 1 then faces[i - 1] = { 2 * i - 3, 2 * i - 2, 2 * i, 2 * i - 1 } end
  end
  return mesh { vertices = vertices, faces = faces, shading = "smooth" }
    :material(matte(paper)):name "paper"
end

local function softbox(center, size, radiance)
  return rectangle_light {
    center = center, size = size, at = { 0, 0, 1.5 }, radiance = radiance, name = "softbox",
  }
end

local plinth = group {
  cylinder { from = { 0, 0, 0 }, to = { 0, 0, 0.14 }, radius = 1.8 },
  cylinder { from = { 0, 0, 0.14 }, to = { 0, 0, 0.5 }, radius = 1.45 },
}:material(matte "#1d5148"):name "plinth"

return scene {
  camera = perspective {
    from = { 0, -12, 3.2 }, at = { 0, 0, 1.38 }, fov = 18, aperture = 0.06, focus = { 0, -0.4, 1 },
  },
  lights = {
    softbox({ -7, -3, 5.5 }, { 6, 6.5 }, { 5.0, 4.7, 4.4 }),
    softbox({ 7, 0, 3.2 }, { 2.4, 6 }, { 4.1, 4.3, 4.7 }),
    softbox({ 0, 2, 9 }, { 9, 5 }, 2.6),
    environment { color = { 0.14, 0.14, 0.14 } },
  },
  objects = { sweep(), plinth, group(subject):translate { z = 0.5 } },
  render = { size = { 900, 900 }, samples = 160 },
}
