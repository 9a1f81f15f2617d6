-- The studio most pictures of the first wing are taken in: floor, softboxes and a dim room.
local studio = {}

local function softbox(center, size, radiance)
  return rectangle_light {
    center = center, size = size, at = { 0, 0, 0.8 }, radiance = radiance, name = "softbox",
  }
end

--- Lights: a warm window at the left, a cool one at the right, a strip above and behind.
function studio.lights()
  return {
    softbox({ -6, -5, 6 }, { 7, 6 }, { 5.6, 5.2, 4.7 }),
    softbox({ 7, -3, 5 }, { 5, 6 }, { 2.9, 3.2, 3.7 }),
    softbox({ 0, 6, 8 }, { 10, 3 }, { 4.6, 4.6, 4.6 }),
    environment { color = { 0.34, 0.35, 0.37 } },
  }
end

function studio.floor(color) return plane { material = matte(color), name = "floor" } end

studio.size = { 640, 400 }

return studio
