-- A street of lanterns: nearly seven thousand lights, windows and bulbs of garlands across a wet
-- street, each an object that glows. For every point a tree over all of them finds the few that
-- matter there.

-- Numbers that look random and stay the same.
local seed = 11
local function random(low, high)
  seed = (seed * 16807) % 2147483647
  return (low or 0) + ((high or 1) - (low or 0)) * seed / 2147483647
end

local lights, houses = {}, {}
local count = param("bulbs", 60) -- of a garland

local hues = { "#ffb45a", "#ff8a3c", "#ffd08a", "#ff5a4a", "#ffc070", "#6ab8ff" }

--- Bulbs along a rope that hangs across the street at y.
local function garland(y, height, sag)
  local hue = hues[1 + math.floor(random() * #hues)]
  for i = 0, count do
    local t = 2 * i / count - 1
    lights[#lights + 1] = sphere_light {
      center = { 3.1 * t, y + 0.5 * t, height - sag * (1 - t * t) }, radius = 0.035,
      color = hue, radiance = 6, name = "bulb",
    }
  end
end

--- A house on the side of x = -1 or 1, from y on, with rows of windows; some of them are lit.
local walls = { "#7d5a48", "#8a7a64", "#6b6f78", "#94604a", "#a08c70" }
local function house(side, y, width, height)
  local face = side * 3.2
  local far = side * 6
  local body = box {
    min = { math.min(face, far), y, 0 }, max = { math.max(face, far), y + width - 0.04, height },
  }
  local openings = {}
  local columns = math.floor(width / 0.75)
  for floor = 0, math.floor((height - 0.5) / 1.1) - 1 do
    for column = 0, columns - 1 do
      local cy = y + width * (column + 0.5) / columns
      local z = 0.45 + 1.1 * floor
      openings[#openings + 1] = box {
        min = { face - 0.15, cy - 0.2, z }, max = { face + 0.15, cy + 0.2, z + 0.65 },
      }
      if random() < 0.55 then
        local warm = random(0.5, 1.6)
        lights[#lights + 1] = rectangle_light {
          center = { face + 0.1 * side, cy, z + 0.325 }, size = { 0.4, 0.65 },
          normal = { -side, 0, 0 }, radiance = { 1.3 * warm, 0.75 * warm, 0.3 * warm },
          name = "window",
        }
      end
    end
  end
  local wall = walls[1 + math.floor(random() * #walls)]
  houses[#houses + 1] = (body - union(openings)):material(matte(wall))
end

for _, side in ipairs { -1, 1 } do
  local y = -10
  while y < 110 do
    local width = random(2.2, 3.6)
    house(side, y, width, random(3.6, 7.2))
    y = y + width
  end
end
for i = 0, 100 do garland(-4 + 1.1 * i, random(3.1, 4.8), random(0.4, 1.3)) end

local puddles = ramp { fbm { seed = 3 }:scale(1.6), from = 0.35, to = 0.6 }
local street = metal {
  color = { 0.13, 0.135, 0.15 }, roughness = ramp { puddles, colors = { 0.22, 0.48 } },
}

return scene {
  camera = perspective { from = { 0.7, -8.5, 1.5 }, at = { 0, 10, 2.4 }, fov = 42, fov_axis = "y" },
  lights = { lights, environment { color = { 0.012, 0.018, 0.045 } } },
  objects = { houses, plane { material = street } },
  render = { size = { 640, 400 }, samples = 128, max_depth = 4 },
  film = { exposure = 2 },
}
