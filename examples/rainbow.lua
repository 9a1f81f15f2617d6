-- Rainbow: Newton's dark room. A beam falls through a slit, runs over the table into a prism of
-- flint glass, and fans out to a spectrum on table and wall.
--
--   lapidary render rainbow.lua
--   lapidary render rainbow.lua --set glass=N-BK7    crown glass spreads it much less
--   lapidary render rainbow.lua --set slit=0.4       a wide slit mixes neighbouring colours
--   lapidary render rainbow.lua --set turn=12        turned away from where it bends light least
--
-- Nothing here knows of colours but the index of the glass, which depends on the wavelength.

local kind = param("glass", "N-SF11") -- of the prism
local slit = param("slit", 0.1)       -- its width
local turn = param("turn", 0)         -- of the prism, in degrees

-- The index at 550 nm, to stand the prism where it bends light least.
local indices = {
  ["N-SF11"] = 1.791, ["N-BK7"] = 1.5185, ["fused silica"] = 1.460,
  sapphire = 1.771, water = 1.3345,
}
local index = indices[kind] or error("no prism of " .. tostring(kind) .. " is prepared here")

-- The beam comes along +x, going down a little. Inside of the prism it runs parallel to its base,
-- having been turned by half of the whole deviation.
local elevation = param("elevation", 9) -- of the lamp, in degrees
local half_turn = math.deg(math.asin(index * math.sin(math.rad(30)))) - 30

local side, tall = 1.4, 1.5
local reach = side * math.sqrt(3) / 6 -- from the middle of the triangle to its sides
local wedge = prism {
  points = { { -side / 2, reach }, { side / 2, reach }, { 0, -2 * reach } }, height = tall,
}:translate { side / 4, reach / 2, 0 } -- the beam meets the middle of a side, at {0, 0}

-- The shutter stands between lamp and prism; its slit ends a little above the table.
local shutter = box { min = { -3.3, -6, 0 }, max = { -3.2, 4.2, 9 } }
  - box { min = { -4, -slit / 2, 0.02 }, max = { -3, slit / 2, 1.9 } }

local down = math.tan(math.rad(elevation))

return scene {
  unit = "dm",
  camera = perspective { from = { 0.9, -9.6, 6.4 }, at = { 0.95, 1.3, 0.6 }, fov = 26 },
  lights = {
    spot_light {
      from = { -60, 0, 60 * down }, at = { -3.2, 0, 1 }, angle = 2.4, intensity = 3400,
    },
    rectangle_light {
      center = { 1, -5, 9 }, size = { 8, 5 }, at = { 0, 0, 0 }, radiance = { 0.22, 0.25, 0.33 },
    },
    environment { color = { 0.06, 0.066, 0.08 } },
  },
  objects = {
    wedge:rotate { z = half_turn + turn }:material(glass(kind)):name "prism",
    shutter:material(matte "#1c1a19"):name "shutter",
    plane { material = matte "#e4e0d8", name = "table" },
    plane {
      point = { 0, 4.2, 0 }, normal = { 0, -1, 0 }, material = matte "#eceae6", name = "wall",
    },
  },
  render = { size = { 800, 600 }, samples = 192, max_depth = 12 },
}
