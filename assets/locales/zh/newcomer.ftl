### Hints for newcomers, shown one after another in the first world.

hints-look = 环顾四周：{ $key }
hints-walk = 行走：{ $key }
hints-jump = 跳跃：{ $key }
hints-dig = 按住挖掘：{ $key }
hints-build = 按住建造：{ $key }
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
