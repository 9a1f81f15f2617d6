-- Ring: the curve that a low lamp draws inside a polished wedding ring, and in every cup of tea.
--
--   lapidary render ring.lua
--   lapidary render ring.lua --set height=50         a lamp higher up: less of the curve
--   lapidary render ring.lua --set lamp=0.6          a larger one blurs it
--   lapidary render ring.lua --set roughness=0.1     brushed gold scatters it
--
-- Rays that come in side by side leave the round wall so that they all touch one curve, half of a
-- nephroid; its cusp lies midway between wall and axis. The ring is turned from bars and tori.

local height = param("height", 27) -- of the lamp over the horizon, in degrees
local lamp = param("lamp", 0.06)   -- its radius, at a distance of 12
local roughness = param("roughness", 0)

--- A band around the z axis, from z = -width / 2 to width / 2: domed outside, straight within, with
--- rounded edges.
local function band(inner, thick, width)
  local function bar(radius, half)
    return cylinder { from = { 0, 0, -half }, to = { 0, 0, half }, radius = radius }
  end
  local edge = thick / 2
  local function rim(z)
    return torus { center = { 0, 0, z }, major_radius = inner + edge, minor_radius = edge }
  end
  local dome = sphere { radius = math.sqrt((inner + thick) ^ 2 + (width / 2 - edge) ^ 2) }
  return (bar(2 * inner, width / 2 - edge) & dome) + rim(width / 2 - edge) + rim(edge - width / 2)
    - bar(inner, width)
end

local a = math.rad(height)
local toward_lamp = { -0.6 * math.cos(a), -0.8 * math.cos(a), math.sin(a) }

return scene {
  unit = "cm",
  camera = perspective {
    from = { 0.9, -6.2, 5.0 }, at = { 0.4, 0.26, 0.2 }, fov = 23, aperture = 0.09,
    focus = { 0, -0.5, 0 },
  },
  lights = {
    sphere_light {
      center = { 12 * toward_lamp[1], 12 * toward_lamp[2], 12 * toward_lamp[3] }, radius = lamp,
      power = 0.7, color = { 1, 0.9, 0.76 },
    },
    rectangle_light {
      center = { 5, -3, 5 }, size = { 4, 4 }, at = { 0, 0, 0 }, radiance = { 0.5, 0.55, 0.65 },
    },
    rectangle_light {
      center = { -5, -1, 6 }, size = { 2.5, 5 }, at = { 0, 0, 0 }, radiance = { 1.3, 1.2, 1.05 },
    },
    environment { color = { 0.14, 0.15, 0.17 } },
  },
  objects = {
    band(0.9, 0.11, 0.4):translate { z = 0.2 }
      :material(metal { "gold", roughness = roughness }):name "gold ring",
    band(0.74, 0.09, 0.32):rotate { x = 90, z = 50 }:translate { 1.65, 0.85, 0.838 }
      :material(metal { "silver", roughness = roughness }):name "silver ring",
    plane { material = matte "#d8cbb8", name = "table" },
  },
  render = { size = { 800, 600 }, samples = 192, max_depth = 12 },
}
