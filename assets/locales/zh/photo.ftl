### 截图与拍照模式。

action-screenshot = 截图
action-photo-mode = 拍照模式

picture-kept = 图片已保存为 { $file }
picture-disk-full = 没有空间写入图片 { $path }。请腾出空间后再试。
picture-read-only = 无法写入图片 { $path }：该位置为只读或属于他人。
picture-not-kept = 无法保存图片 { $path }：{ $reason }
picture-not-taken = 无法拍摄图片：{ $reason }

photo-title = 拍照模式
photo-field-of-view = 视野
photo-time = 时间
photo-curvature = 曲率
photo-bend = 弯曲
photo-figures = 隐藏人物
photo-thirds = 三分网格
photo-size = 尺寸
photo-size-times = { $times } ×（{ $width } × { $height }）
photo-save = 保存图片
photo-leave = 离开
photo-fly = { $keys } 飞行，按住鼠标键转动视角，方向键在列表中移动
photo-saving = 正在保存：{ $percent } %
photo-left = 完成之前离开了拍照模式
photo-dial = { $value }
