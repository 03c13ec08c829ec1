### Hints for newcomers, shown one after another in the first world. { $key } and the like are keys, buttons or sticks.

hints-look = Look around: { $key }
hints-walk = Walk: { $key }
hints-jump = Jump: { $key }
hints-corner = Five squares meet at every corner, not four, and a stone stands there, and five paths lead away from it. Walk round it and count them. Gone through: { $gone } · large map: { $key }
hints-corner-back = Five squares, and you are back. On flat ground it would have been four.
hints-overhead = Look up: the land over your head is the other side of this world.
hints-talk = Talk to somebody ahead: { $key }
hints-car = Get into a car, close by: { $key }
hints-map = Change to the other picture of this space: { $key }
hints-camera = See yourself from behind, and back: { $key }
hints-light = It is dark. Flashlight: { $key }
hints-photo = Take pictures: { $key }
hints-home = Walk straight on, in any direction, until you are home.
hints-dig = Dig, held down: { $key }
hints-build = Build, held down: { $key }
hints-make = You build with what you dig. Make tools of it: { $key }, then Make things
hints-curve = Change how space is pictured: { $up } and { $down }
hints-backpack = Open the backpack: { $key }
hints-menu = Pause, settings, all the keys: { $key }
hints-footer = { $step } of { $count } · skip: { $key }
hints-footer-plain = { $step } of { $count }
hints-stick-left = left stick
hints-stick-right = right stick

menu-skip-hints = Skip the hints
action-skip-hint = Skip a hint
setting-hints = Hints for newcomers
setting-hints-about = Shows hints in the world, one after another. The setting switches itself off after the last hint. Switch it on again to start over.
