### Bildschirmfotos und der Fotomodus.

action-screenshot = Bildschirmfoto
action-photo-mode = Fotomodus

picture-kept = Bild aufgehoben als { $file }
picture-disk-full = Für das Bild { $path } ist kein Platz mehr. Schaffe Platz und versuche es noch einmal.
picture-read-only = Das Bild { $path } kann nicht geschrieben werden: Der Ort ist schreibgeschützt oder gehört jemand anderem.
picture-not-kept = Das Bild { $path } konnte nicht aufgehoben werden: { $reason }
picture-not-taken = Es konnte kein Bild gemacht werden: { $reason }

photo-title = Fotomodus
photo-field-of-view = Blickfeld
photo-time = Tageszeit
photo-curvature = Krümmung
photo-bend = Biegung
photo-figures = Figuren verbergen
photo-thirds = Drittelgitter
photo-size = Größe
photo-size-times = { $times } × ({ $width } × { $height })
photo-save = Bild speichern
photo-leave = Verlassen
photo-fly = { $keys } fliegen, eine gehaltene Maustaste dreht den Blick, die Pfeiltasten gehen durch diese Liste
photo-saving = Speichere: { $percent } %
photo-left = der Fotomodus wurde verlassen, bevor es fertig war
photo-dial = { $value }
