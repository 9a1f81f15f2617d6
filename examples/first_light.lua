-- First light: a cut diamond and a knot of gold on black lacquer, before the sun is up.
--
--   lapidary render first_light.lua
--   lapidary render first_light.lua --set stone=sapphire --set turn=20
--   lapidary render first_light.lua --size 1920x1080 --samples 512 -o first_light.exr
--
-- A lapidary cuts stones. This one is the round brilliant of the jewellers, built here from the
-- angles they state; the knot is a bar swept along a curve on a torus. Both are plain Lua.

local stone = param("stone", "diamond") -- a glass that `lapidary help glass` lists, or an index
local turn = param("turn", 0)           -- degrees the stone is turned on the table

local cos, sin, tan, pi = math.cos, math.sin, math.tan, math.pi

-- The stone ------------------------------------------------------------------------------------

-- Angles of the main facets to the girdle, in degrees; radii of the rings of corners and the
-- thickness of the girdle, where the stone's own radius is 1.
local cut = {
  crown = 34.5, pavilion = 40.75,
  table = 0.56, star = 0.78, lower = 0.26, girdle = 0.04,
}

--- A round brilliant around the z axis, its table up and z = 0 half way through its girdle.
local function brilliant()
  local crown, pavilion = tan(math.rad(cut.crown)), tan(math.rad(cut.pavilion))
  local edge = cut.girdle / 2

  local vertices, faces = {}, {}
  local function corner(radius, angle, z)
    vertices[#vertices + 1] = { radius * cos(angle), radius * sin(angle), z }
    return #vertices
  end
  --- A ring of corners; gives the function from place in the ring to number of the corner.
  local function ring(count, first_angle, radius, z)
    local numbers = {}
    for i = 0, count - 1 do
      numbers[i] = corner(radius, first_angle + 2 * pi * i / count, z)
    end
    return function(i) return numbers[i % count] end
  end
  local function facet(...) faces[#faces + 1] = { ... } end

  -- A corner between two main facets lies in the planes of both, which gives its height.
  local function reach(radius) return 1 - radius * cos(pi / 8) end
  local table_ring = ring(8, 0, cut.table, edge + (1 - cut.table) * crown)
  local stars = ring(8, pi / 8, cut.star, edge + reach(cut.star) * crown)
  local upper = ring(16, 0, 1, edge)
  local under = ring(16, 0, 1, -edge)
  local lower = ring(8, pi / 8, cut.lower, -edge - reach(cut.lower) * pavilion)
  local culet = corner(0, 0, -edge - pavilion)

  local top = {}
  for i = 0, 7 do top[i + 1] = table_ring(i) end
  faces[1] = top
  for i = 0, 7 do
    local a, b, c = 2 * i, 2 * i + 1, 2 * i + 2 -- of the girdle
    facet(table_ring(i), stars(i), table_ring(i + 1))
    facet(table_ring(i), stars(i - 1), upper(a), stars(i))
    facet(stars(i), upper(a), upper(b))
    facet(stars(i), upper(b), upper(c))
    facet(under(a), under(b), upper(b), upper(a))
    facet(under(b), under(c), upper(c), upper(b))
    facet(lower(i), under(b), under(a))
    facet(lower(i), under(c), under(b))
    facet(lower(i), under(a), lower(i - 1), culet)
  end
  return mesh { vertices = vertices, faces = faces, shading = "flat" }
end

--- Turns a brilliant so that it rests on one main facet of its pavilion.
local function at_rest(gem)
  local lean = math.rad(cut.pavilion)
  local height = (cut.girdle / 2 + tan(lean)) * cos(lean) + 1e-4 -- on the table, not in it
  return gem:rotate { y = cut.pavilion, z = turn - 100 }:translate { z = height }
end

-- The knot -------------------------------------------------------------------------------------

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

local function unit(a)
  local length = math.sqrt(a[1] ^ 2 + a[2] ^ 2 + a[3] ^ 2)
  return { a[1] / length, a[2] / length, a[3] / length }
end

--- A squarish bar along the knot that winds p times around the axis of a torus and q times
--- through its hole. The bar makes `turns` quarter turns on the way, so that it meets itself.
local function knot(k)
  local steps, sides = 720, 48 -- along the bar, around it; sides in fours

  local function curve(t)
    local r = k.major + k.minor * cos(k.q * t)
    return { r * cos(k.p * t), r * sin(k.p * t), k.minor * sin(k.q * t) }
  end
  --- Two directions across the bar at t; the first is square to the torus.
  local function across(t)
    local a, b = curve(t - 1e-4), curve(t + 1e-4)
    local forward = unit { b[1] - a[1], b[2] - a[2], b[3] - a[3] }
    local out = { cos(k.q * t) * cos(k.p * t), cos(k.q * t) * sin(k.p * t), sin(k.q * t) }
    local side = unit(cross(forward, out))
    return cross(side, forward), side
  end

  local vertices, faces = {}, {}
  for i = 0, steps - 1 do
    local t = 2 * pi * i / steps
    local middle, up, side = curve(t), across(t)
    for j = 0, sides - 1 do
      local s = 2 * pi * j / sides
      local radius = k.bar * (cos(s) ^ 4 + sin(s) ^ 4) ^ -0.25 -- a square with soft corners
      local angle = s + k.turns * t / 4
      local x, y = radius * cos(angle), radius * sin(angle)
      vertices[#vertices + 1] = {
        middle[1] + x * up[1] + y * side[1],
        middle[2] + x * up[2] + y * side[2],
        middle[3] + x * up[3] + y * side[3],
      }
    end
  end

  local function number(i, j)
    if i == steps then i, j = 0, j + k.turns * sides // 4 end
    return i * sides + j % sides + 1
  end
  for i = 0, steps - 1 do
    for j = 0, sides - 1 do
      faces[#faces + 1] =
        { number(i, j), number(i, j + 1), number(i + 1, j + 1), number(i + 1, j) }
    end
  end
  return mesh { vertices = vertices, faces = faces, shading = "smooth" }
end

-- The sky --------------------------------------------------------------------------------------

--- Bands of light that stand `distance` away and fade upwards from the horizon.
local function dawn(distance)
  local height, count = 16, 90
  -- Share of the height, and the radiance there.
  local sky = {
    { 0.00, { 1.25, 0.60, 0.30 } },
    { 0.08, { 0.85, 0.42, 0.30 } },
    { 0.20, { 0.34, 0.24, 0.33 } },
    { 0.45, { 0.10, 0.13, 0.26 } },
    { 1.00, { 0.02, 0.03, 0.08 } },
  }
  local function radiance(h)
    local i = 2
    while h > sky[i][1] do i = i + 1 end
    local low, high = sky[i - 1], sky[i]
    local share = (h - low[1]) / (high[1] - low[1])
    local mixed = {}
    for c = 1, 3 do mixed[c] = low[2][c] + share * (high[2][c] - low[2][c]) end
    return mixed
  end

  local bands = {}
  for i = 1, count do -- narrow ones first, where the colours change fastest
    local bottom, top = ((i - 1) / count) ^ 1.5, (i / count) ^ 1.5
    local middle = (bottom + top) / 2
    bands[i] = rectangle_light {
      center = { 0, distance, middle * height }, size = { 70, (top - bottom) * height },
      normal = { 0, -1, 0 }, radiance = radiance(middle), name = "sky",
    }
  end
  return bands
end

-- The scene ------------------------------------------------------------------------------------

local function ball(x, y, radius, material)
  return sphere { center = { x, y, radius }, radius = radius, material = material }
end

local function globe(x, y, radius)
  return sphere_light {
    center = { x, y, radius }, radius = radius, radiance = { 2.6, 1.4, 0.6 }, name = "globe",
  }
end

local function softbox(center, size, radiance)
  return rectangle_light {
    center = center, size = size, at = { 0, 0, 0.7 }, radiance = radiance, name = "softbox",
  }
end

local lacquer = metal { color = { 0.035, 0.04, 0.05 }, roughness = 0.22 }

return scene {
  camera = perspective {
    from = { 0, -11, 2.6 }, at = { 0.1, 0, 1.05 }, fov = 21,
    aperture = 0.12, focus = { -0.75, -2.2, 0.8 },
  },

  lights = {
    dawn(12),
    globe(-3.1, 3.2, 0.9), globe(-0.3, 5.5, 0.55), globe(3.9, 4.8, 0.65),
    softbox({ -7, -5, 5 }, { 6, 5 }, { 2.4, 2.0, 1.6 }),
    softbox({ 8, -2, 3 }, { 2, 6 }, { 1.8, 1.3, 0.9 }),
    softbox({ 0, -2, 9 }, { 5, 2 }, { 0.7, 1.2, 2.1 }),
    softbox({ -2, -15, 7 }, { 16, 6 }, { 1.3, 1.15, 0.95 }),
    environment { color = { 0.12, 0.10, 0.11 } },
  },

  objects = {
    plane { material = lacquer, name = "table" },
    at_rest(brilliant()):translate { -0.75, -1.6, 0 }:material(glass(stone)):name "stone",
    knot { p = 2, q = 3, major = 1, minor = 0.45, bar = 0.2, turns = 4 }
      :rotate { z = 100 }:rotate { x = 78, z = 22 } -- upright, on two of its three loops
      :scale(0.95):translate { 1.32, 0.6, 1.299 }
      :material(metal { "gold", roughness = 0.12 })
      :name "knot",
    ball(-3.0, 0.9, 0.56, glass(1.5)),
    ball(2.45, -1.2, 0.40, metal { color = { 0.03, 0.26, 0.34 }, roughness = 0.18 }),
    ball(0.50, -2.4, 0.19, metal "silver"),
    ball(1.35, -2.9, 0.13, metal { "copper", roughness = 0.12 }),
  },

  render = { size = { 960, 540 }, samples = 160 },
}
