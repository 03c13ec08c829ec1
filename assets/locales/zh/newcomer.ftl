### Hints for newcomers, shown one after another in the first world.

hints-look = 环顾四周：{ $key }
hints-walk = 行走：{ $key }
hints-jump = 跳跃：{ $key }
hints-corner = 每个角有五个方块相接，而不是四个，那里立着一块石头，五条小路从那里伸出。绕它走一圈，数一数。已走过：{ $gone } · 大地图：{ $key }
hints-corner-back = 走过五个方块，你又回到了起点。在平地上只要四个。
hints-overhead = 抬头看：头顶上的大地是这个世界的另一面。
hints-talk = 和前面的人说话：{ $key }
hints-car = 走近后上车：{ $key }
hints-map = 切换到这个空间的另一幅画面：{ $key }
hints-camera = 从背后看自己，再切回：{ $key }
hints-light = 这里很暗。手电筒：{ $key }
hints-photo = 拍照：{ $key }
hints-home = 朝任意方向一直往前走，直到回家。
hints-dig = 按住挖掘：{ $key }
hints-build = 按住建造：{ $key }
hints-make = 你用挖到的东西建造，也可以用它做工具：{ $key }，然后选“制作”
hints-curve = 改变空间的画面：{ $up }和{ $down }
hints-backpack = 打开背包：{ $key }
hints-menu = 暂停、设置和全部按键：{ $key }
hints-footer = { $step } / { $count } · 跳过：{ $key }
hints-footer-plain = { $step } / { $count }
hints-stick-left = 左摇杆
hints-stick-right = 右摇杆

menu-skip-hints = 跳过提示
action-skip-hint = 跳过一条提示
setting-hints = 新手提示
setting-hints-about = 在世界中逐条告诉你可以做什么。最后一条之后自动关闭；打开则从头开始。
