### 声音与手柄。运行时生成的键：setting-<id>、key-<id>。

settings-group-sound = 声音
settings-group-pad = 手柄
unit-percent = { $value }%
unit-degrees-per-second = 每秒 { $value }°

setting-volume-master = 音量
setting-volume-master-about = 全部声音的音量。
setting-volume-effects = 脚步与工具
setting-volume-effects-about = 脚步、落地、挖掘和建造的音量。
setting-volume-ambience = 风、昼与夜
setting-volume-ambience-about = 风声、白天的鸟鸣和夜晚的虫鸣的音量。
setting-volume-music = 音乐
setting-volume-music-about = 音乐的音量；它很轻，停顿很长。
setting-volume-interface = 菜单与物品栏
setting-volume-interface-about = 菜单和物品栏提示音的音量。
setting-mute-elsewhere = 后台静音
setting-mute-elsewhere-about = 键盘在别的窗口时不发出声音。
setting-pad-look-speed = 摇杆转动速度
setting-pad-look-speed-about = 右摇杆推到底时视角转动的快慢。
setting-pad-invert-look = 摇杆上下颠倒
setting-pad-invert-look-about = 向前推右摇杆时向下看，如同驾驶飞机。
setting-pad-dead-zone = 摇杆静止范围
setting-pad-dead-zone-about = 摇杆偏离中心多远仍算松开。视角自行转动时可调大。

sound-none = 没有声音设备；游戏照常进行。接上设备后会自动使用。
sound-lost = 声音设备已断开；游戏照常进行，并等待新的设备。
sound-left-out = 此版本不含声音。

pad-connected = 手柄已连接：{ $name }
pad-disconnected = 手柄已断开：{ $name }

key-pad-south = 手柄 A（下）
key-pad-east = 手柄 B（右）
key-pad-west = 手柄 X（左）
key-pad-north = 手柄 Y（上）
key-pad-left-bumper = 手柄左肩键
key-pad-right-bumper = 手柄右肩键
key-pad-left-trigger = 手柄左扳机
key-pad-right-trigger = 手柄右扳机
key-pad-select = 手柄 Select
key-pad-start = 手柄 Start
key-pad-left-stick = 按下左摇杆
key-pad-right-stick = 按下右摇杆
key-pad-up = 手柄十字键上
key-pad-down = 手柄十字键下
key-pad-left = 手柄十字键左
key-pad-right = 手柄十字键右
