### Lo que se lee en las salas que trae el juego: sus nombres en las listas, sus frases y sus carteles.

room-long-house-name = La casa larga
room-long-house-sentence = Por fuera esta casa mide 8 metros de largo, y su pasillo, 79.
room-big-house-name = La casa grande
room-big-house-sentence = Esta cabaña mide 4 metros de ancho y tiene dentro una sala de 12, el doble de alta que la cabaña.
room-twelve-rooms-name = Doce habitaciones
room-twelve-rooms-sentence = En esta casa de 5 por 5 metros hay doce habitaciones de 5 por 5 metros cada una.
room-nested-boxes-name = Cajas dentro de cajas
room-nested-boxes-sentence = Hay cuatro cajas, una dentro de otra, y cada una te hace la mitad de grande, de modo que la bola del centro es una colina.
room-four-tunnels-name = Cuatro túneles
room-four-tunnels-sentence = Los cuatro túneles miden 79 metros, pero a pie uno tiene 26 metros y otro 395, el tercero es más estrecho de lo que parece, y el cuarto más bajo.
room-four-tunnels-shorter-sign = d = +2 a lo largo: parece medir 26 metros.
room-four-tunnels-shorter-number = 26 m de largo
room-four-tunnels-longer-sign = d = -0,8 a lo largo: parece medir 395 metros.
room-four-tunnels-longer-number = 395 m de largo
room-four-tunnels-narrower-sign = d = +0,7 a lo ancho: 9,5 metros parecen 5,6.
room-four-tunnels-narrower-number = 5,6 m de ancho
room-four-tunnels-lower-sign = d = +0,8 a lo alto: 10,5 metros parecen 5,8.
room-four-tunnels-lower-number = 5,8 m de alto
room-thesis-room-name = La sala de la tesis
room-thesis-room-sentence = Entra y serás el doble de grande: esta sala de 12 por 8 metros mide 6 por 4 para quien está en ella.
room-two-portals-name = Dos portales
room-two-portals-sentence = Entra por la puerta azul y saldrás por la naranja, esté donde esté.
room-six-portals-name = Seis portales
room-six-portals-sentence = Este pabellón está abierto por sus seis lados, y quien sale por uno entra por el opuesto.
room-endless-stair-name = La escalera sin fin
room-endless-stair-sentence = Esta escalera tiene dieciséis peldaños, y quien la sube nunca llega al último.
room-door-to-itself-name = La puerta a sí misma
room-door-to-itself-sentence = Esto no es un espejo, sino una puerta a sí misma, y quien entra vuelve a salir.
room-growing-hall-name = La sala donde se crece
room-growing-hall-sentence = Cada una de estas puertas lleva a otra el doble de grande, y tú también lo serás.
room-bottomless-shaft-name = El pozo sin fondo
room-bottomless-shaft-sentence = Quien salta a este pozo cae para siempre, y solo tiene ocho metros de hondo.
room-falling-crate-name = La caja que cae
room-falling-crate-sentence = Esta caja cae desde que llegaste y nunca llega abajo; salta tras ella y pronto flota a tu lado.
room-way-back-name = El camino de vuelta
room-way-back-sentence = Hasta el otro extremo de este pasillo hay sesenta metros, y desde allí de vuelta, quince.
room-closet-flat-name = El piso en el armario
room-closet-flat-sentence = En este armario de un metro cuadrado hay un piso entero.
