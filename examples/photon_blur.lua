-- Photon blur: balls of glass gather the light of coloured lamps to points, and the maps that hold
-- these are blurred: by a Gaussian to circles, by a box to crosses.
--
--   lapidary render photon_blur.lua
--   lapidary render photon_blur.lua --set filter=box       crosses
--   lapidary render photon_blur.lua --set radius=0.05      hardly blurred
--
-- A box takes the mean along one axis of a surface's coordinates, and along the other: what was a
-- point is spread over both lines and nowhere between them, and the cross turns with its surface.
-- A Gaussian along one axis and then along the other is the same in all directions, because the
-- product of the two depends on the distance alone.

local filter = param("filter", "gaussian") -- "gaussian" or "box"
local radius = param("radius", 0.4) -- of the blur

local colors = { "#ff4a3d", "#ffb02e", "#6fe06a", "#3fa9ff", "#b06bff" }

local function place(i) return 1.75 * (i - 3) end

-- A pendant lamp: a shade about a small bulb, so that it lights one ball and no other.
local inside = cone { from = { 0, 0, 2.45 }, to = { 0, 0, 3.25 }, radius = 0.345, radius2 = 0.11 }
local shade = cone { from = { 0, 0, 2.47 }, to = { 0, 0, 3.3 }, radius = 0.36, radius2 = 0.14 }
    :material(matte "#e8e6e0")
  - inside:material(matte "#141414")
local cord = cylinder { from = { 0, 0, 3.29 }, to = { 0, 0, 9 }, radius = 0.015 }

-- The light of a bulb 1.75 above the middle of a ball of radius 0.5 meets 1.26 below it, that of
-- its rim a little higher.
local ball = sphere { center = { 0, 0, 1.15 }, radius = 0.5, material = glass "N-BK7" }
local pin = cylinder { from = { 0.47, 0, 0 }, to = { 0.47, 0, 1.03 }, radius = 0.016 }

local lamps, things = {}, {}
for i, color in ipairs(colors) do
  local x = place(i)
  lamps[#lamps + 1] = sphere_light {
    center = { x, 0, 2.9 }, radius = 0.04, power = 40, color = color,
  }
  things[#things + 1] = group {
    shade:name "shade",
    cord:material(matte "#303030"):name "cord",
    ball:name "ball",
    group {
      pin:rotate { z = 90 }, pin:rotate { z = 210 }, pin:rotate { z = 330 },
    }:material(metal { "gold", roughness = 0.2 }):name "pins",
  }:translate { x, 0, 0 }
  -- A tile whose coordinates are turned a little more from ball to ball.
  things[#things + 1] = box {
    min = { -0.72, -0.72, -0.06 }, max = { 0.72, 0.72, 0 }, material = matte "#dcd8d0",
    name = "tile " .. i,
  }:rotate { z = 15 * (i - 3) }:translate { x, 0, 0 }
end

return scene {
  camera = perspective { from = { 0, -8.2, 5.4 }, at = { 0, 0, 1.3 }, fov = 40 },
  lights = {
    lamps[1], lamps[2], lamps[3], lamps[4], lamps[5],
    environment { color = { 0.06, 0.07, 0.09 } },
  },
  objects = {
    group(things),
    plane { point = { 0, 0, -0.06 }, material = matte "#5a5f68", name = "floor" },
  },
  render = {
    size = { 1000, 562 }, samples = 64, integrator = "illumination",
    map_photons = 2000000, map_filter = filter, map_radius = radius, map_resolution = 40,
  },
}
