### The lists of worlds.

worlds-none = 还没有世界。“新游戏”会创建一个。
worlds-load-named = 载入“{ $name }”
worlds-delete-named = 删除“{ $name }”
worlds-manage = 管理“{ $name }”
worlds-running = 正在进行
worlds-running-no-delete = 这个世界正在进行。请先保存并退出到菜单，然后再删除。
worlds-running-no-change = 这个世界正在进行。请先保存并退出到菜单，然后再更改。
worlds-cannot-load-title = 无法载入“{ $name }”
worlds-cannot-delete-title = 现在无法删除“{ $name }”

# What is known of a world.
worlds-played = 已玩 { $time }
worlds-played-briefly = 不到一分钟
worlds-played-minutes = { $minutes } 分钟
worlds-played-hours = { $hours } 小时 { $minutes } 分钟
worlds-size = { $megabytes } MB
worlds-size-small = { $kilobytes } kB
worlds-edits = { $count ->
    [0] 尚无改动
   *[other] 改动了 { $count } 个区块
}
worlds-edits-unknown = 正在统计改动的区块

# The page of one world.
worlds-load = 载入
worlds-rename = 重命名
worlds-duplicate = 复制
worlds-export = 导出
worlds-open-folder = 打开文件夹
worlds-delete = 删除
worlds-keep = 保留
worlds-cancel = 取消
worlds-delete-question = 删除“{ $name }”？
worlds-delete-final = 此操作无法撤销。
worlds-rename-title = 重命名“{ $name }”
worlds-new-name = 新名称
worlds-name-free = 这个名称可以使用。
worlds-export-title = 导出“{ $name }”
worlds-file = 文件
worlds-export-hint = 整个世界写入这一个文件，可以保存或送人。不会覆盖任何文件。

# Worlds from files.
worlds-import = 导入
worlds-import-title = 导入世界
worlds-import-do = 导入
worlds-import-hint = 导出的世界文件。也可以把它拖到窗口上。
worlds-found = { $dir } 中导出的世界：
worlds-found-none = { $dir } 中没有导出的世界。
worlds-import-named = { $name }（{ $size }）
worlds-folder-named = { $name }（文件夹）
worlds-folder-above = 上一层文件夹
worlds-folder-unread = 无法读取 { $dir }（{ $reason }）。请选择其他文件夹，或输入路径。
worlds-export-folders = 文件将存到 { $dir }。其他文件夹：

# Work on the saves, and what it came to.
worlds-work-delete = 正在删除世界
worlds-work-rename = 正在重命名世界
worlds-work-duplicate = 正在复制世界
worlds-work-export = 正在导出世界
worlds-work-import = 正在导入世界
worlds-renamed = 世界现在名为“{ $name }”。
worlds-duplicated = “{ $name }”是该世界的副本。
worlds-exported = 世界已写入 { $file }。
worlds-imported = 已导入“{ $name }”。
worlds-list-died = 无法读取世界列表；详情见日志。
worlds-work-died = 操作时出错；详情见日志。
worlds-folder-failed = 无法打开文件夹 { $dir }：{ $reason }。可以手动打开。
worlds-folder-no-program = 找不到显示文件夹的程序
worlds-folder-refused = 系统找不到可以显示它的程序

# Rooms of deformed space, where they are told in other words than worlds.
rooms-none = 还没有房间。
rooms-new = 新房间
rooms-load-named = 进入“{ $name }”
rooms-running = 你正在其中
rooms-running-no-change = 你正在这个房间里。请先离开，然后再更改。
rooms-shipped = 这个房间是游戏自带的。复制它才能更改。
rooms-objects = { $count ->
   *[other] { $count } 个物体
}
rooms-load = 进入
rooms-export-hint = 整个房间写入这一个文件，可以保存或送人。不会覆盖任何文件。
rooms-import-title = 导入房间
rooms-import-hint = 导出的房间文件。也可以把它拖到窗口上。
rooms-found = { $dir } 中导出的房间：
rooms-found-none = { $dir } 中没有导出的房间。
rooms-work-delete = 正在删除房间
rooms-work-rename = 正在重命名房间
rooms-work-duplicate = 正在复制房间
rooms-work-export = 正在导出房间
rooms-work-import = 正在导入房间
rooms-renamed = 房间现在名为“{ $name }”。
rooms-duplicated = “{ $name }”是该房间的副本。
rooms-exported = 房间已写入 { $file }。
rooms-imported = 已导入“{ $name }”。
rooms-list-died = 无法读取房间列表；详情见日志。
