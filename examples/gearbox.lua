-- Gearbox: two pairs of gears between two shafts, their housing cut open at the shafts' height.
--
--   lapidary render gearbox.lua
--   lapidary render gearbox.lua --set turn=7         the input shaft seven degrees further
--   lapidary render gearbox.lua --set open=false     closed again
--
-- Loops and functions make the parts: teeth are true involutes, so that they roll on each other;
-- rings of bearings are cut by a torus for their balls. A section takes away what is in one more
-- solid, and the faces it leaves wear that solid's material: red is where iron was cut. It is
-- taken of the housing alone; of a group, or as `section = ...` of the scene, it cuts all there is.

local turn, open = param("turn", 0), param("open", true)

local cos, sin, pi = math.cos, math.sin, math.pi

local iron = metal { color = { 0.50, 0.50, 0.52 }, roughness = 0.35 }
local bright = metal { color = { 0.75, 0.74, 0.72 }, roughness = 0.2 }
local brass = metal { "gold", roughness = 0.38 }
local paint = matte "#5b7f8e"
local marking = matte "#c23b22"

--- A round bar along x.
local function bar(x0, x1, radius)
  return cylinder { from = { x0, 0, 0 }, to = { x1, 0, 0 }, radius = radius }
end

-- Gears ----------------------------------------------------------------------------------------

local module, pressure = 0.1, math.rad(20) -- pitch diameter of one tooth, and angle of the push

--- The outline of a gear around {0, 0}, a tooth pointing along the first axis.
local function outline(teeth)
  local pitch = module * teeth / 2
  local base, tip, root = pitch * cos(pressure), pitch + module, pitch - 1.2 * module
  local function involute(r) -- how far the flank turns from the base circle out to r
    local t = math.sqrt(math.max(0, (r / base) ^ 2 - 1))
    return t - math.atan(t)
  end
  local half = pi / (2 * teeth) * 0.97 + involute(pitch) -- of a tooth at the base; some backlash
  local points, steps = {}, 7
  for tooth = 0, teeth - 1 do
    local middle = 2 * pi * tooth / teeth
    local function corner(r, angle)
      points[#points + 1] = { r * cos(middle + angle), r * sin(middle + angle) }
    end
    local foot = math.max(base, root)
    if root < base then corner(root, -half) end
    for i = 0, steps do
      local r = foot + (tip - foot) * i / steps
      corner(r, involute(r) - half)
    end
    for i = steps, 0, -1 do
      local r = foot + (tip - foot) * i / steps
      corner(r, half - involute(r))
    end
    if root < base then corner(root, half) end
  end
  return points
end

--- A gear on the x axis from x0 to x1, turned by an angle; large ones have holes in their web.
local function gear(teeth, x0, x1, angle)
  local pitch, wide = module * teeth / 2, x1 - x0
  local body = prism { points = outline(teeth), height = wide }
  if pitch > 1.2 then
    local rim, hub = pitch - 0.32, 0.52
    local tub = cylinder { from = { 0, 0, wide - 0.1 }, to = { 0, 0, wide }, radius = rim }
      - cylinder { from = { 0, 0, 0 }, to = { 0, 0, wide }, radius = hub }
    body = body - tub - tub:translate { z = 0.1 - wide }
    local holes = {}
    for i = 1, 6 do
      local a, r = i * pi / 3, (rim + hub) / 2
      holes[i] = cylinder {
        from = { r * cos(a), r * sin(a), 0 }, to = { r * cos(a), r * sin(a), wide },
        radius = 0.36 * (rim - hub),
      }
    end
    body = difference { body, holes }
  end
  return body:rotate { z = angle }:rotate { y = 90 }:translate { x0, 0, 0 }
end

-- Bearings -------------------------------------------------------------------------------------

local bore, bearing_radius, bearing_width = 0.3, 0.66, 0.36

--- Two rings with a groove each, and the balls between them; the middle at x.
local function bearing(x)
  local x0, x1 = x - bearing_width / 2, x + bearing_width / 2
  local track = (bore + bearing_radius) / 2
  local groove = torus {
    center = { x, 0, 0 }, axis = { 1, 0, 0 }, major_radius = track, minor_radius = 0.12,
  }
  local rings = bar(x0, x1, bearing_radius) - bar(x0, x1, track + 0.06)
    + (bar(x0, x1, track - 0.06) - bar(x0, x1, bore)) - groove
  local balls = {}
  for i = 1, 9 do
    local a = 2 * pi * (i + 0.25) / 9
    balls[i] = sphere { center = { x, track * cos(a), track * sin(a) }, radius = 0.118 }
  end
  return group { rings, balls }:material(bright)
end

-- Putting it together --------------------------------------------------------------------------

local apart = 3 -- of the shafts: the teeth of each pair add up to 60
local left, right, wall = -2.2, 2.2, 0.28 -- ends of the housing, and how thick it is

local function countershaft(part) return part:translate { 0, apart, 0 } end

--- The angle of a gear that meets another one, which is turned by `angle` and lies opposite to the
--- direction `toward`: its gaps are where the other's teeth are.
local function meeting(teeth, other, angle, toward)
  return toward + 180 + 180 / teeth - (angle - toward) * other / teeth
end

-- The drawing of a gear has its first axis down and its second from the main to the countershaft.
local second = meeting(45, 15, turn, 90)
local third = meeting(42, 18, second, 270)

local moving = group {
  bar(-3.4, -0.15, bore):material(iron),                                            -- input
  bar(0.15, 3.6, bore):material(iron),                                              -- output
  countershaft(bar(left, right, bore)):material(iron),
  gear(15, -1.6, -0.7, turn):material(brass),
  countershaft(gear(45, -1.5, -0.8, second)):material(iron),
  countershaft(gear(18, 0.7, 1.6, second)):material(brass),
  gear(42, 0.8, 1.5, third):material(iron),
}

--- The space of the two shafts: `grown` beyond the gears, from x0 to x1.
local function around_gears(x0, x1, grown)
  local radius = 2.45 + grown
  return bar(x0, x1, radius) + countershaft(bar(x0, x1, radius))
    + box { min = { x0, 0, -radius }, max = { x1, apart, radius } }
end

local seats = union {
  bar(left, right, bearing_radius), countershaft(bar(left, right, bearing_radius)),
}
local flange = box {
  min = { left - 0.35, -3.1, -0.2 }, max = { right + 0.35, apart + 3.1, 0.2 },
}
local bolts = {}
for i = 0, 5 do
  for _, x in ipairs { left - 0.18, right + 0.18 } do
    local y = -2.6 + i * (apart + 5.2) / 5
    bolts[#bolts + 1] = cylinder { from = { x, y, -0.2 }, to = { x, y, 0.2 }, radius = 0.09 }
  end
end
local feet = box { min = { left, -2.4, -3 }, max = { right, apart + 2.4, -2.6 } }
local housing = around_gears(left, right, wall) + flange + feet
  - around_gears(left + wall, right - wall, 0) - seats - union(bolts)

for _, x in ipairs { left + wall / 2 + 0.04, right - wall / 2 - 0.04 } do
  moving = group { moving, bearing(x), countershaft(bearing(x)) }
end

if open then -- without what is above the shafts
  housing = housing:section(half_space { normal = { 0, 0, -1 }, material = marking })
end

return scene {
  camera = perspective { from = { -7.5, -12, 9 }, at = { 0.05, 1.1, -0.7 }, fov = 28 },
  lights = {
    rectangle_light {
      center = { -8, -2, 9 }, size = { 10, 10 }, at = { 0, 1, 0 }, radiance = { 2.6, 2.5, 2.4 },
    },
    rectangle_light {
      center = { 4, 10, 9 }, size = { 9, 4 }, at = { 0, 1, 0 }, radiance = { 2.6, 2.8, 3.1 },
    },
    rectangle_light {
      center = { -14, -5, 3 }, size = { 8, 7 }, at = { 0, 1, 0 }, radiance = { 1.6, 1.6, 1.7 },
    },
    environment { color = { 0.6, 0.61, 0.63 } },
  },
  objects = {
    moving, housing:material(paint):name "housing",
    plane { point = { 0, 0, -3 }, material = matte "#8f8a82", name = "bench" },
  },
  render = { size = { 900, 600 }, samples = 144 },
}
