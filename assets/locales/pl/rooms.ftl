### Co można przeczytać w pokojach z gry: ich nazwy na listach, ich zdania i tablice.

room-long-house-name = Długi dom
room-long-house-sentence = Z zewnątrz ten dom ma 8 metrów długości, a jego korytarz 79.
room-big-house-name = Duży dom
room-big-house-sentence = Ta chata ma 4 metry szerokości, a mieści salę szeroką na 12 metrów i dwa razy wyższą niż ona sama.
room-twelve-rooms-name = Dwanaście pokoi
room-twelve-rooms-sentence = W tym domu o wymiarach 5 na 5 metrów jest dwanaście pokoi, każdy 5 na 5 metrów.
room-nested-boxes-name = Pudła w pudłach
room-nested-boxes-sentence = Cztery pudła stoją jedno w drugim, a każde zmniejsza cię o połowę, tak że kula pośrodku jest wzgórzem.
room-four-tunnels-name = Cztery tunele
room-four-tunnels-sentence = Wszystkie cztery tunele mają 79 metrów, ale pieszo jeden ma 26 metrów, a drugi 395, trzeci jest węższy, niż wygląda, a czwarty niższy.
room-four-tunnels-shorter-sign = d = +2 wzdłuż: wydaje się mieć 26 metrów.
room-four-tunnels-shorter-number = 26 m długości
room-four-tunnels-longer-sign = d = -0,8 wzdłuż: wydaje się mieć 395 metrów.
room-four-tunnels-longer-number = 395 m długości
room-four-tunnels-narrower-sign = d = +0,7 wszerz: 9,5 metra wydaje się mieć 5,6.
room-four-tunnels-narrower-number = 5,6 m szerokości
room-four-tunnels-lower-sign = d = +0,8 w górę: 10,5 metra wydaje się mieć 5,8.
room-four-tunnels-lower-number = 5,8 m wysokości
room-thesis-room-name = Sala z pracy dyplomowej
room-thesis-room-sentence = Wejdź, a będziesz dwa razy większy: ta sala 12 na 8 metrów ma 6 na 4 dla tego, kto w niej jest.
room-two-portals-name = Dwa portale
room-two-portals-sentence = Wejdź w niebieskie drzwi, a wyjdziesz z pomarańczowych, gdziekolwiek stoją.
room-six-portals-name = Sześć portali
room-six-portals-sentence = Ten pawilon jest otwarty z sześciu stron, a kto wychodzi jedną, wchodzi przeciwną.
room-endless-stair-name = Schody bez końca
room-endless-stair-sentence = Te schody mają szesnaście stopni, a kto po nich wchodzi, nigdy nie dochodzi do ostatniego.
room-door-to-itself-name = Drzwi do samych siebie
room-door-to-itself-sentence = To nie lustro, lecz drzwi do samych siebie, a kto w nie wchodzi, wychodzi z powrotem.
room-growing-hall-name = Sala, w której się rośnie
room-growing-hall-sentence = Każde z tych drzwi prowadzą do dwa razy większych, a ty też rośniesz dwukrotnie.
room-bottomless-shaft-name = Szyb bez dna
room-bottomless-shaft-sentence = Kto skoczy do tego szybu, spada bez końca, a ma on tylko osiem metrów głębokości.
room-falling-crate-name = Spadająca skrzynia
room-falling-crate-sentence = Ta skrzynia spada, odkąd tu jesteś, i nigdy nie doleci; skocz za nią, a wkrótce zawiśnie obok ciebie.
room-way-back-name = Droga powrotna
room-way-back-sentence = Do drugiego końca tego korytarza jest sześćdziesiąt metrów, a stamtąd z powrotem piętnaście.
room-closet-flat-name = Mieszkanie w szafie
room-closet-flat-sentence = W tej szafie o powierzchni jednego metra kwadratowego jest całe mieszkanie.
