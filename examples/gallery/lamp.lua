-- A lamp that writes on walls: a shade of brass, pierced by 184 stars. Each is a pyramid that
-- points at the one small bulb and is cut out of the shell, so the light through it draws the star
-- again on the wall.

local cos, sin, pi = math.cos, math.sin, math.pi

--- A blunt pyramid over a star with n points, from 1.15 to 0.5 below the origin, to which its
--- edges point.
local function star(n, size)
  local points = {}
  for i = 0, 2 * n - 1 do
    local r = i % 2 == 0 and size or 0.45 * size
    points[i + 1] = { r * cos(pi * i / n), r * sin(pi * i / n) }
  end
  return prism { points = points, height = 0.65, scale = 0.5 / 1.15 }:translate { z = -1.15 }
end

-- Rows of stars around the bulb, large ones and small ones in turn.
local holes = {}
for row = -5, 5 do
  local elevation = 13 * row
  local large = row % 2 == 0
  local count = math.floor(22 * cos(math.rad(elevation)) + 0.5)
  for i = 0, count - 1 do
    local turn = 360 * (i + (large and 0 or 0.5)) / count
    holes[#holes + 1] = star(large and 6 or 4, large and 0.15 or 0.09)
      :rotate { z = 15 }:rotate { y = -90 - elevation, z = turn }
  end
end

local function egg(grow)
  return ellipsoid { radii = { 0.74 + grow, 0.74 + grow, 1.02 + grow } }
end

local brass = metal { color = { 0.75, 0.5, 0.2 }, roughness = 0.35 }
local soot = matte "#140e08"
local shade = difference { egg(0.012):material(brass), egg(-0.012):material(soot), holes }
local fittings = union {
  cylinder { from = { 0, 0, 1 }, to = { 0, 0, 1.2 }, radius = 0.2 },
  torus { center = { 0, 0, 1 }, major_radius = 0.22, minor_radius = 0.035 },
  sphere { center = { 0, 0, 1.24 }, radius = 0.1 },
  sphere { center = { 0, 0, -0.9 }, radius = 0.07 },
  cylinder { from = { 0, 0, 1.2 }, to = { 0, 0, 4 }, radius = 0.015 },
}
local plaster = matte "#c9b8a2"
local boards = matte(wood { colors = { "#8a6542", "#5b3d24" } }:scale(0.5):rotate { y = 88 })

return scene {
  unit = "dm",
  camera = perspective {
    from = { 0.8, -9.2, 2.3 }, at = { 0.1, 0, 2.55 }, fov = 32, fov_axis = "y",
  },
  lights = {
    sphere_light { center = { 0, 0, 2.7 }, radius = 0.02, power = 30, temperature = 3000 },
    environment { color = { 0.012, 0.016, 0.03 } },
  },
  objects = {
    shade:translate { z = 2.7 }:name "shade",
    fittings:material(brass):translate { z = 2.7 }:name "fittings",
    plane { material = boards },
    plane { point = { 0, 2.6, 0 }, normal = { 0, -1, 0 }, material = plaster },
    plane { point = { -3.6, 0, 0 }, normal = { 1, 0, 0 }, material = plaster },
  },
  render = { size = { 640, 400 }, samples = 128, max_depth = 4 },
}
