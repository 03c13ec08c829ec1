### 主菜单、新世界表单和对话框。

# 按钮栏。
menu-resume = 继续游戏
menu-save = 保存
menu-save-and-quit = 保存并返回菜单
menu-begin-anew = 重新开始
menu-build-here = 在这里建造
menu-leave-room = 离开房间
menu-new-game = 新游戏
menu-load = 载入
menu-delete = 删除
menu-rooms = 房间
menu-workshop = 工坊
menu-controls = 操作
menu-quit = 退出游戏
version = 版本 { $version }
adapter-software = 没有找到显卡：由处理器绘制（{ $adapter }），分辨率为窗口的 { $percent }%。较小的窗口或视距会有帮助。
running-world = { $name } · 种子 { $seed }

back = 返回
ok = 确定
percent = { $percent }%

# 新世界表单。
name = 名称
name-hint = 叫什么名字？
name-offered = 世界 { $number }
name-free = 这个名称可以使用。
name-not-shown = 其中有些字符无法在此显示，旁边将标出文件夹的名称。
space = 空间
geometry-hyperbolic = 双曲透镜
geometry-hyperbolic-about = 平坦无边的大地，在弯曲空间里观看：四面下沉，弯多少由滚轮决定。
geometry-hyperbolic-world = 双曲世界
geometry-hyperbolic-world-about = 比平地更宽广：每个角上有五个方块相接，回去的路并不是你以为的那条。
geometry-euclidean = 欧几里得
geometry-euclidean-about = 平直的空间，无边而熟悉。
geometry-spherical = 球面
geometry-spherical-about = 封闭的世界：大地升起，在头顶相接；绕它走一圈，就会回到家。
mode = 模式
mode-creative = 创造
mode-creative-about = 一开始就有全部工具，建造不花任何东西。
mode-gathering = 采集
mode-gathering-about = 挖到什么就能用什么建造，工具也由此制作。
seed = 种子（可选）
seed-hint = 数字或文字
seed-random = 留空则随机抽取。
seed-is = 种子是 { $seed }。
seed-too-large = 太大：最大的种子是 18446744073709551615。
seed-not-whole = 数字必须是非负整数：只能用数字。
seed-too-long = 太长：最多 64 个字符。
seed-unprintable = 请只用可显示的字符。
radius-metres = { $metres } 米
radius = 大小：世界半径
radius-moonlet = 小卫星
radius-moon = 月球
radius-planet = 行星
radius-named = { $name }，{ $metres } 米
radius-round = 绕一圈：{ $metres } 米，步行 { $minutes } 分钟。
squares = 大小：方块的宽度，每个角五块
squares-wide = { $metres } 米
squares-land = { $metres } 米以内的土地是平地的 { $times } 倍。
create = 创建
needs-name = 需要有效的名称
needs-seed = 需要有效的种子

# 离开前无法保存的世界。
unsaved-title = 世界尚未保存
unsaved-again = 重试
unsaved-stay = 留在世界中
unsaved-leave = 不保存就离开

# 玩家正在等待的事。
busy-opening = 正在打开
busy-opening-about = 正在从磁盘读取世界。
busy-opening-room = 正在从磁盘读取房间并准备画面。
busy-land = 正在生成大地
busy-saving = 正在保存
busy-saving-about = 正在把你的世界写入磁盘。
busy-leaving = 正在离开
