### Was in den Räumen des Spiels zu lesen ist: ihre Namen in Listen, ihre Sätze und ihre Schilder.

room-long-house-name = Das lange Haus
room-long-house-sentence = Von außen ist dieses Haus 8 Meter lang, und sein Flur hat 79.
room-big-house-name = Das große Haus
room-big-house-sentence = Diese Hütte ist 4 Meter breit, und in ihr ist ein Saal von 12 Metern, doppelt so hoch wie die Hütte.
room-twelve-rooms-name = Zwölf Zimmer
room-twelve-rooms-sentence = In diesem Haus von 5 mal 5 Metern sind zwölf Zimmer von je 5 mal 5 Metern.
room-nested-boxes-name = Kästen in Kästen
room-nested-boxes-sentence = Vier Kästen stehen ineinander, und jeder macht dich halb so groß, sodass die Kugel in der Mitte ein Hügel ist.
room-four-tunnels-name = Vier Tunnel
room-four-tunnels-sentence = Alle vier Tunnel sind 79 Meter lang, aber zu Fuß sind es in einem 26 Meter und in einem 395, der dritte ist schmaler, als er aussieht, und der vierte niedriger.
room-four-tunnels-shorter-sign = d = +2 in der Länge: Er fühlt sich an wie 26 Meter.
room-four-tunnels-shorter-number = 26 m lang
room-four-tunnels-longer-sign = d = -0,8 in der Länge: Er fühlt sich an wie 395 Meter.
room-four-tunnels-longer-number = 395 m lang
room-four-tunnels-narrower-sign = d = +0,7 in der Breite: 9,5 Meter fühlen sich an wie 5,6.
room-four-tunnels-narrower-number = 5,6 m breit
room-four-tunnels-lower-sign = d = +0,8 in der Höhe: 10,5 Meter fühlen sich an wie 5,8.
room-four-tunnels-lower-number = 5,8 m hoch
room-thesis-room-name = Der Raum der Abschlussarbeit
room-thesis-room-sentence = Geh hinein, und du bist doppelt so groß: Diese Halle von 12 mal 8 Metern misst für den, der in ihr ist, 6 mal 4.
room-two-portals-name = Zwei Portale
room-two-portals-sentence = Geh in die blaue Tür hinein, und du kommst aus der orangen heraus, wo immer sie steht.
room-six-portals-name = Sechs Portale
room-six-portals-sentence = Dieser Pavillon ist nach allen sechs Seiten offen, und wer auf einer hinausgeht, kommt auf der anderen wieder herein.
room-endless-stair-name = Die endlose Treppe
room-endless-stair-sentence = Diese Treppe hat sechzehn Stufen, und wer sie hinaufsteigt, kommt nie auf die letzte.
room-door-to-itself-name = Die Tür zu sich selbst
room-door-to-itself-sentence = Das ist kein Spiegel, sondern eine Tür zu sich selbst, und wer hineingeht, kommt wieder heraus.
room-growing-hall-name = Die Halle, in der man wächst
room-growing-hall-sentence = Geh durch eine Tür: du kommst aus einer doppelt so großen heraus und bist selbst doppelt so groß.
room-bottomless-shaft-name = Der bodenlose Schacht
room-bottomless-shaft-sentence = Wer in diesen Schacht springt, fällt für immer, und er ist nur acht Meter tief.
room-falling-crate-name = Die fallende Kiste
room-falling-crate-sentence = Diese Kiste fällt, seit du da bist, und kommt nie an; spring ihr nach, und bald schwebt sie still in deiner Nähe.
room-way-back-name = Der Rückweg
room-way-back-sentence = Bis ans andere Ende dieses Gangs sind es sechzig Meter, und von dort zurück fünfzehn.
room-closet-flat-name = Die Wohnung im Schrank
room-closet-flat-sentence = In diesem Schrank von einem Quadratmeter ist eine ganze Wohnung.
