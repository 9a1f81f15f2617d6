-- A town at night seen from a hill: ten thousand lamps, half of them small balls, half of them
-- panels that look down, each of which lights little but its own surroundings.

local per_side = param("per_side", 100)
local random = math.random

local lights, houses = {}, {}
for i = 1, per_side do
  for j = 1, per_side do
    local x, y = i - per_side / 2 + 0.6 * (random() - 0.5), j + 0.6 * (random() - 0.5)
    local strength = { power = 0.5 + 12 * random() ^ 4, temperature = 2000 + 5000 * random() }
    if (i + j) % 2 == 0 then
      strength.center, strength.radius = { x, y, 0.1 + 0.5 * random() }, 0.06
      lights[#lights + 1] = sphere_light(strength)
    else
      strength.center, strength.normal = { x, y, 0.3 + 0.7 * random() }, { 0, 0, -1 }
      strength.size = { 0.12, 0.12 }
      lights[#lights + 1] = rectangle_light(strength)
    end
    if random() < 0.3 then
      houses[#houses + 1] = box {
        min = { i - per_side / 2 + 0.4, j + 0.4, 0 },
        max = { i - per_side / 2 + 0.7, j + 0.7, 0.2 + random() },
      }
    end
  end
end

return scene {
  camera = perspective { from = { 0, -2, 6 }, at = { 0, 7, 0 }, fov = 48 },
  lights = lights,
  objects = {
    plane { material = matte { color = { 0.5, 0.5, 0.5 } } },
    group { houses, material = matte { color = { 0.6, 0.55, 0.5 } } },
  },
  render = { size = { 240, 160 }, samples = 16, max_depth = 3, filter = "box" },
}
