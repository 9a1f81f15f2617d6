-- Prism: white light from a slit, drawn out into its colours on a silver screen.
--
--   lapidary render prism.lua
--   lapidary render prism.lua --set glass=N-BK7     crown glass spreads the light much less
--   lapidary render prism.lua --set slit=0.5        a wide slit mixes neighbouring colours
--
-- The bench of a lecture hall: a lamp behind a slit, a lens that makes a sharp picture of the slit
-- on the screen, and a prism in between, which shifts the picture of each wavelength as its glass
-- demands. Nothing here knows of colours but the dispersion of that glass.
--
-- Paths are traced from the camera, so light is found only by those that leave the screen towards
-- prism and lens and then happen to meet the slit. A wide lens, and a screen that throws light
-- back in few directions, as those of cinemas do, make that likely enough.

local kind = param("glass", "N-SF11") -- of the prism
local slit = param("slit", 0.22)      -- its width

local sin, cos, sqrt = math.sin, math.cos, math.sqrt

-- At 550 nm; light of this wavelength leaves straight towards the middle of the screen.
local indices = {
  ["N-SF11"] = 1.791, ["N-BK7"] = 1.5185, ["fused silica"] = 1.460,
  sapphire = 1.771, water = 1.3345,
}
local index = indices[kind]
if not index then error("no prism of " .. tostring(kind) .. " is prepared here") end

local apex = math.rad(60)         -- angle of the prism
-- Its edges. The beam stays clear of the base, which would throw a second picture of the slit,
-- without colours, on the screen: there the prism bends light forth and back.
local side, tall = 3.2, 1.5
local lens_width = 1.4
local height = 2.3                -- of the beam over the table
local to_slit, to_screen = 6, 6   -- from the lens, from the prism
local gap = 1.8                   -- from lens to prism

-- Light passes the prism parallel to its base, and is turned by this angle.
local turn = 2 * math.asin(index * sin(apex / 2)) - apex

-- Points and directions {x, y} of the bench, seen from above ------------------------------------

local function along(p, direction, distance)
  return { p[1] + distance * direction[1], p[2] + distance * direction[2] }
end

local function left_of(d) return { -d[2], d[1] } end

local inward = { sin(turn), cos(turn) }           -- the beam before the prism
local within = { sin(turn / 2), cos(turn / 2) }   -- inside of it
local outward = { 0, 1 }                          -- and after it
local to_apex = { within[2], -within[1] }

local entry, exit = along({ 0, 0 }, within, -side / 4), along({ 0, 0 }, within, side / 4)
local lens_middle = along(entry, inward, -gap)
local slit_middle = along(lens_middle, inward, -to_slit)

--- A column over the polygon `outline`, which runs counter-clockwise seen from above.
local function column(outline, bottom, top)
  local vertices, faces, floor, roof = {}, {}, {}, {}
  local n = #outline
  for i, p in ipairs(outline) do
    local j = i % n + 1
    vertices[i] = { p[1], p[2], bottom }
    vertices[n + i] = { p[1], p[2], top }
    faces[i] = { i, j, n + j, n + i }
    floor[n + 1 - i], roof[i] = i, n + i
  end
  faces[n + 1], faces[n + 2] = floor, roof
  return mesh { vertices = vertices, faces = faces }
end

-- The prism ------------------------------------------------------------------------------------

local altitude = side * sqrt(3) / 2
local tip = along({ 0, 0 }, to_apex, altitude / 2)
local base = along({ 0, 0 }, to_apex, -altitude / 2)
local prism = column(
  { tip, along(base, within, side / 2), along(base, within, -side / 2) },
  height - tall / 2, height + tall / 2
):material(glass(kind)):name "prism"

-- The lens -------------------------------------------------------------------------------------

--- Outline of a lens, flat towards the slit, that brings light from a point `from` before it to a
--- point `to` behind its flat face. Light takes the same time on all ways between the two, which
--- says how far a ray that enters at height y goes in the glass.
local function lens_outline(half_width, thickness, n, from, to)
  local time = from + n * thickness + to - thickness
  local outline, steps = {}, 48
  for i = -steps, steps do
    local y = half_width * i / steps
    local before = sqrt(from ^ 2 + y ^ 2)
    local s = y / before / n
    local c = sqrt(1 - s ^ 2)
    -- Leaving at (c t, y + s t), the rest of the way takes time - before - n t.
    local left = time - before
    local b = n * left - c * to + s * y
    local t = (b - sqrt(b ^ 2 - (n ^ 2 - 1) * (left ^ 2 - to ^ 2 - y ^ 2))) / (n ^ 2 - 1)
    local p = along(lens_middle, inward, c * t)
    outline[#outline + 1] = along(p, left_of(inward), y + s * t)
  end
  outline[#outline + 1] = along(lens_middle, left_of(inward), half_width)
  outline[#outline + 1] = along(lens_middle, left_of(inward), -half_width)
  return outline
end

local function lens()
  local n = 1.5 -- of no real glass: one that brings all colours to the same point
  local to_image = gap + side / 2 + to_screen
  local outline = lens_outline(lens_width / 2 - 0.005, 0.26, n, to_slit, to_image)
  return column(outline, height - tall / 2, height + tall / 2)
    :material(glass(n)):name "lens"
end

-- The lamp -------------------------------------------------------------------------------------

local enamel = metal { color = { 0.24, 0.26, 0.29 }, roughness = 0.35 }
local black = matte { color = { 0.02, 0.02, 0.02 } }

--- Like daylight behind a filter that takes away the far violet: the eye hardly sees it, so few
--- paths carry those wavelengths, and what they bring would be grain.
local white = spectrum {
  from = 410, step = 10, values = { 0, 0.004, 0.014, 0.028, 0.04, 0.045, 0.045 },
}

local function lamp()
  local a = along(slit_middle, left_of(inward), -slit / 2)
  local b = along(slit_middle, left_of(inward), slit / 2)
  return rectangle_light {
    corner = { a[1], a[2], height - 0.6 * tall },
    edge_u = { b[1] - a[1], b[2] - a[2], 0 }, edge_v = { 0, 0, 1.2 * tall },
    radiance = white, name = "slit",
  }
end

--- A housing from behind the slit to the lens: boards that are black inside.
local function housing()
  local front, back = along(lens_middle, inward, -0.01), along(slit_middle, inward, -0.3)
  local function board(left, right, bottom, top, material, from, to)
    local outline = {
      along(to, left_of(inward), -right), along(to, left_of(inward), -left),
      along(from, left_of(inward), -left), along(from, left_of(inward), -right),
    }
    return column(outline, height + bottom, height + top):material(material)
  end
  local w, h, thin, thick = lens_width / 2, tall / 2, 0.02, 0.16
  local function around(w, h, thick, material)
    return {
      board(-w - thick, -w, -h, h, material, back, front),
      board(w, w + thick, -h, h, material, back, front),
      board(-w - thick, w + thick, -h - thick, -h, material, back, front),
      board(-w - thick, w + thick, h, h + thick, material, back, front),
    }
  end
  local rear = along(back, inward, -thick)
  return group {
    group(around(w, h, thin, black)),
    group(around(w + thin, h + thin, thick, enamel)),
    board(-w - thick, w + thick, -h - thick, h + thick, black, rear, back),
  }:name "housing"
end

-- The screen -----------------------------------------------------------------------------------

--- A sheet of dull silver, hollow like a dish and leaning back, so that from everywhere on it the
--- mirror direction of the camera is that of the prism.
local function screen()
  local radius, wide, high, columns, rows = 9.4, 2.7, 2.3, 34, 30
  local vertices, faces = {}, {}
  for j = 0, rows do
    for i = 0, columns do
      local x, z = wide * (i / columns - 0.5), high * (j / rows - 0.5)
      vertices[#vertices + 1] = { x, sqrt(radius ^ 2 - x ^ 2 - z ^ 2) - radius, z }
      if i > 0 and j > 0 then
        local n = #vertices
        faces[#faces + 1] = { n - columns - 2, n - columns - 1, n, n - 1 }
      end
    end
  end
  return mesh { vertices = vertices, faces = faces, shading = "smooth" }
    :rotate { x = -9.8 }
    :translate { exit[1] - 0.05, exit[2] + to_screen, height }
    :material(metal { color = { 0.92, 0.92, 0.92 }, roughness = 0.2 })
    :name "screen"
end

-- The scene ------------------------------------------------------------------------------------

local velvet = matte { color = { 0.012, 0.012, 0.014 } }
local table_top = matte { color = { 0.17, 0.165, 0.16 } }

--- What carries the bench: a round post from the table to just under the beam.
local function post(p, radius, material)
  return cylinder {
    from = { p[1], p[2], 0 }, to = { p[1], p[2], height - tall / 2 - 0.2 }, radius = radius,
    material = material,
  }
end

return scene {
  unit = "dm",
  camera = perspective {
    from = { exit[1], -15, height + 7.4 }, at = { exit[1] - 0.6, 2.2, height }, fov = 16.8,
  },
  lights = {
    lamp(),
    rectangle_light {
      center = { -1, 11, 8 }, size = { 10, 4 }, at = { 0, 0, 2 }, radiance = { 1, 1.15, 1.4 },
    },
    rectangle_light {
      center = { 2, 0, 12 }, size = { 8, 5 }, at = { 0, 2, 0 }, radiance = { 5, 4.8, 4.6 },
    },
    rectangle_light {
      center = { 6, -16, 3 }, size = { 8, 3 }, at = { -2, 0, 2.3 }, radiance = { 0.6, 0.62, 0.7 },
    },
    environment { color = { 0.05, 0.055, 0.065 } },
  },
  objects = {
    prism, lens(), housing(), screen(),
    post({ 0, 0 }, 1.95, velvet), post(along(lens_middle, inward, -1.2), 0.35, enamel),
    plane { material = table_top, name = "table" },
  },
  render = { size = { 640, 400 }, samples = 640, max_depth = 12 },
}
