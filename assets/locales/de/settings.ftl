### The settings screen. Keys made at run time: setting-<id>.

menu-settings = Einstellungen
settings-search = Einstellungen durchsuchen
settings-nothing-found = Keine Einstellung spricht von „{ $words }“.
settings-reset = Zurücksetzen
settings-reset-named = „{ $name }“ zurücksetzen

settings-group-look = Maus und Blick
settings-group-picture = Bild
settings-group-world = Raum
settings-group-comfort = Sprache, Lesbarkeit und Behagen

# { $value } is a number.
unit-degrees = { $value }°
unit-degrees-per-pixel = { $value }° je Pixel
unit-chunks = { $value ->
    [0] Automatisch
    [one] { $value } Stück
   *[other] { $value } Stücke
}
unit-notch = { $value } je Raste
unit-times = { $value } ×

setting-mouse-sensitivity = Mausempfindlichkeit
setting-mouse-sensitivity-about = Wie weit sich der Blick dreht, wenn sich die Maus um ein Pixel bewegt.
setting-invert-look = Oben und unten vertauschen
setting-invert-look-about = Die Maus von sich weg zu schieben senkt den Blick, wie im Flugzeug.
setting-field-of-view = Sichtfeld
setting-field-of-view-about = Der Winkel zwischen oberem und unterem Bildrand. Ein weiter zeigt mehr und macht alles kleiner.

setting-preset = Bilder für
setting-preset-about = Mit einer Grafikkarte hat das Land in der Nähe Gras, Rippeln, Kiesel und Schichten und wird Punkt für Punkt beleuchtet. Für den Prozessor hat es nur die Farben seines Bioms, was schneller ist. Automatisch: je nachdem, was zeichnet.
setting-preset-auto = Automatisch
setting-preset-card = Grafikkarte
setting-preset-software = Prozessor

setting-quality = Qualität
setting-quality-about = Wie viel Genauigkeit die Bilder gegen Geschwindigkeit tauschen.
setting-quality-fast = Schnell
setting-quality-balanced = Ausgewogen
setting-quality-exact = Genau
setting-view-distance = Sichtweite
setting-view-distance-about = Wie weit um dich herum Land gemacht wird; ein Stück hat 32 Meter. Automatisch reicht es mit einer Grafikkarte über 300 Meter weit. Jeder Schritt weiter kostet Speicher und Zeit.
setting-render-scale = Auflösung der Welt
setting-render-scale-about = Der Anteil der Fensterauflösung, in dem die Welt gezeichnet wird. Texte bleiben scharf. Automatisch: die ganze mit einer Grafikkarte, die halbe ohne.
setting-render-scale-auto = Automatisch
setting-render-scale-25 = 25 %
setting-render-scale-50 = 50 %
setting-render-scale-67 = 67 %
setting-render-scale-75 = 75 %
setting-render-scale-100 = 100 %
setting-msaa = Glatte Kanten (MSAA)
setting-msaa-about = Nimmt mehrere Proben eines Pixels, wo Land endet, damit Kanten keine Stufen haben. Automatisch: vier Proben mit einer Grafikkarte, eine ohne.
setting-msaa-auto = Automatisch
setting-msaa-off = Aus
setting-msaa-4x = 4 Proben
setting-shadows = Schatten
setting-shadows-about = Schatten, die Sonne und Mond werfen. Hoch ist feiner und weicher. Automatisch: hoch mit einer Grafikkarte, niedrig ohne.
setting-shadows-auto = Automatisch
setting-shadows-off = Aus
setting-shadows-low = Niedrig
setting-shadows-high = Hoch
setting-frame-cap = Bildgrenze
setting-frame-cap-about = Höchstzahl der Bilder je Sekunde. Weniger halten den Rechner kühl und leise.
setting-frame-cap-30 = 30
setting-frame-cap-60 = 60
setting-frame-cap-90 = 90
setting-frame-cap-120 = 120
setting-frame-cap-144 = 144
setting-frame-cap-240 = 240
setting-frame-cap-none = Keine Grenze
setting-vsync = Auf den Bildschirm warten (VSync)
setting-vsync-about = Bilder wechseln nur zwischen zwei Auffrischungen des Bildschirms. Ohne das kommen sie früher und können zerrissen sein.
setting-fullscreen = Vollbild
setting-fullscreen-about = Das Spiel füllt den Bildschirm.

setting-curvature-step = Schritt der Krümmung
setting-curvature-step-about = Wie weit eine Raste des Mausrads die Krümmung verstellt.
setting-hyperbolic-map = Hyperbolische Karte
setting-hyperbolic-map-about = Die Karte, mit der neue hyperbolische Welten beginnen; hier geändert, wechselt sie auch in der Welt, in der du bist. Jede Welt merkt sich ihre eigene.
setting-hyperbolic-map-raised = Gehoben
setting-hyperbolic-map-horizon = Horizont
setting-contour-bands = Höhenlinien
setting-contour-bands-about = Zarte Linien auf dem Land, alle 8 Meter Höhe. Sie zeigen, wie sich der Raum biegt.
setting-compass = Kompass
setting-compass-about = Zeigt oben, wo Norden ist; in sphärischen Welten auch die Halbkugel und den Weg zum Äquator, in hyperbolischen Welten den Weg nach Hause; und die Richtung deiner Fahnen.
setting-minimap = Umgebungskarte
setting-minimap-about = Eine runde Karte des Landes um dich: Höhen, Lampen, Fahnen und wer in der Nähe ist.
setting-rear-mirror = Rückspiegel
setting-rear-mirror-about = Ein Spiegel oben im Blick über die Haube eines Autos. Automatisch: auf einer Grafikkarte, nicht wo der Prozessor zeichnet.
setting-rear-mirror-auto = Automatisch
setting-rear-mirror-off = Aus
setting-rear-mirror-on = Ein
setting-straight-shots = Gerade Schüsse
setting-straight-shots-about = Kugeln folgen den geradesten Linien des Raums, statt im Bogen zu fallen.

setting-language = Sprache
setting-language-about = Die Sprache aller Texte. System ist die deines Rechners, sofern das Spiel sie spricht.
setting-language-system = System
setting-language-en = English
setting-language-pl = Polski
setting-language-de = Deutsch
setting-language-es = Español
setting-language-zh = 中文
setting-ui-scale = Größe von Texten und Knöpfen
setting-ui-scale-about = Wie groß Menüs und Anzeige gezeichnet werden.
setting-high-contrast = Hoher Kontrast
setting-high-contrast-about = Menüs und Anzeige in Weiß und Gelb auf Schwarz, nichts scheint durch.
setting-safe-marker = Ring für Farbenblinde
setting-safe-marker-about = Der Ring um das, was du gräbst oder baust, ist weiß mit schwarzen Rändern: Die Helligkeit spricht, nicht die Farbe.
setting-reduced-motion = Weniger Bewegung
setting-reduced-motion-about = Die Krümmung springt, statt zu gleiten, Menüs blenden nicht, der Kopf federt nicht, der Blick über die Haube neigt sich nicht, und hinter dem Menü zieht keine Welt vorbei.
setting-head-dip = Federn bei der Landung
setting-head-dip-about = Der Blick sinkt ein wenig, wenn du nach einem Sprung oder Sturz landest.
setting-wind = Wind
setting-wind-about = Laub und Gras wiegen sich. Bei weniger Bewegung stehen sie still.

# The file of the settings. { $file } is a path, { $reason } comes from the system, { $value } from the file.
settings-file-damaged = Die Datei der Einstellungen war beschädigt. Was sich lesen ließ, gilt; die beschädigte Datei bleibt als { $file } erhalten.
settings-file-newer = Die Datei der Einstellungen stammt von einer neueren Fassung des Spiels. Was davon bekannt ist, gilt; sie bleibt als { $file } erhalten.
settings-file-older = Die Datei der Einstellungen war von einer älteren Fassung und ist erneuert; die alte bleibt als { $file } erhalten.
settings-file-kept = Einiges aus der Datei der Einstellungen war nicht zu gebrauchen; wie sie war, bleibt sie als { $file } erhalten.
settings-file-value = Die Einstellung „{ $name }“ steht auf ihrem Vorgabewert: In der Datei steht { $value }, was sie nicht annimmt.
settings-file-unknown = Die Datei der Einstellungen nennt „{ $name }“, was diese Fassung nicht kennt.
settings-file-input = „{ $name }“ liegt in der Datei der Einstellungen auf { $value }, das weder Taste noch Knopf noch Rad ist.
settings-file-profile = Das Tastenprofil „{ $name }“ aus der Datei der Einstellungen ist ausgelassen.
settings-file-unreadable = Die Datei der Einstellungen { $file } ließ sich nicht lesen ({ $reason }). Es gelten die Vorgaben, und Änderungen werden nicht gespeichert.
settings-file-stuck = Die Datei der Einstellungen { $file } ließ sich nicht beiseitelegen ({ $reason }). Sie bleibt, wie sie ist, und Änderungen werden nicht gespeichert.
settings-file-no-place = Das System nennt keinen Ort für Einstellungen, also werden Änderungen nicht gespeichert. --config FILE nennt einen.
settings-file-unsaved = Die Einstellungen ließen sich nicht nach { $file } speichern ({ $reason }). Sie gelten bis zum Ende des Spiels.
settings-file-more = { $count ->
    [one] Noch etwas aus der Datei der Einstellungen war nicht zu gebrauchen.
   *[other] Noch { $count } Dinge aus der Datei der Einstellungen waren nicht zu gebrauchen.
}
settings-not-applied = Diese Einstellung ließ sich nicht anwenden: { $reason }
