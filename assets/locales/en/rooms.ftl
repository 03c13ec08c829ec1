### What is read in the rooms that come with the game: their names in lists, their sentences and their signs.

room-long-house-name = The long house
room-long-house-sentence = From outside this house is 8 metres long, and its corridor is 79.
room-big-house-name = The big house
room-big-house-sentence = This hut is 4 metres wide and has a hall of 12 in it, and the hall is twice as high as the hut.
room-twelve-rooms-name = Twelve rooms
room-twelve-rooms-sentence = In this house of 5 by 5 metres there are twelve rooms of 5 by 5 metres each.
room-nested-boxes-name = Nested boxes
room-nested-boxes-sentence = Four boxes stand in one another, and each makes you half as large, so that the ball in the middle is a hill.
room-four-tunnels-name = Four tunnels
room-four-tunnels-sentence = All four tunnels are 79 metres long, but on foot one takes 26 metres and one 395, the third is narrower than it looks, and the fourth lower.
room-four-tunnels-shorter-sign = d = +2 along its length: it feels like 26 metres.
room-four-tunnels-shorter-number = 26 m long
room-four-tunnels-longer-sign = d = -0.8 along its length: it feels like 395 metres.
room-four-tunnels-longer-number = 395 m long
room-four-tunnels-narrower-sign = d = +0.7 across it: 9.5 metres feel like 5.6.
room-four-tunnels-narrower-number = 5.6 m wide
room-four-tunnels-lower-sign = d = +0.8 upward: 10.5 metres feel like 5.8.
room-four-tunnels-lower-number = 5.8 m high
room-thesis-room-name = The room of the thesis
room-thesis-room-sentence = Walk in and you are twice as large: this hall of 12 by 8 metres is 6 by 4 for who is in it.
room-two-portals-name = Two portals
room-two-portals-sentence = Walk into the blue door and you walk out of the orange one, wherever that stands.
room-six-portals-name = Six portals
room-six-portals-sentence = This pavilion is open on all six sides, and whoever leaves by one side comes in by the opposite one.
room-endless-stair-name = The endless stair
room-endless-stair-sentence = This stair has sixteen steps, and whoever climbs it never comes to the last one.
room-door-to-itself-name = The door to itself
room-door-to-itself-sentence = This is no mirror but a door to itself, and whoever walks in comes back out.
room-growing-hall-name = The hall where one grows
room-growing-hall-sentence = Go through a door: you come out of one twice as large, and are twice as large, too.
room-bottomless-shaft-name = The bottomless shaft
room-bottomless-shaft-sentence = Whoever jumps into this shaft falls for ever, and it is only eight metres deep.
room-falling-crate-name = The falling crate
room-falling-crate-sentence = This crate has been falling since you came, and it never lands; jump after it, and soon it hangs still near you.
room-way-back-name = The way back
room-way-back-sentence = It is sixty metres to the other end of this corridor, and fifteen from there back.
room-closet-flat-name = The flat in the closet
room-closet-flat-sentence = In this closet of one square metre there is a whole flat.
