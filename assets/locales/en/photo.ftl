### Screenshots and the photo mode.

action-screenshot = Screenshot
action-photo-mode = Photo mode

# { $file } and { $path } are files, { $reason } comes from the system.
picture-kept = Picture kept as { $file }
picture-disk-full = There is no space left to write the picture { $path }. Free some space and try again.
picture-read-only = The picture { $path } cannot be written: the folder is read-only or belongs to someone else.
picture-not-kept = The picture { $path } could not be kept: { $reason }
picture-not-taken = No picture could be taken: { $reason }

photo-title = Photo mode
photo-field-of-view = Field of view
photo-time = Time of day
photo-curvature = Curvature
photo-bend = Bend
photo-figures = Hide figures
photo-thirds = Grid of thirds
photo-size = Size
photo-size-times = { $times } × ({ $width } × { $height })
photo-save = Save the picture
photo-leave = Leave
photo-fly = { $keys } fly, a held mouse button turns the view, the arrow keys move through this list
photo-saving = Saving: { $percent } %
photo-left = the photo mode was left before it was finished
photo-dial = { $value }
