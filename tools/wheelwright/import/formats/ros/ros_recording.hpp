// Recordings of ROS 1 and ROS 2: bags of version 2.0 (wiki.ros.org/Bags/Format/2.0), MCAP files
// (mcap.dev/spec), SQLite files of rosbag2 (.db3), and the folder of a ROS 2 bag, whose files are one
// recording.
//
// A stream for each topic, named by it, its type without "msg": "geometry_msgs/Twist". The rows of a topic
// are in order of the time at which they were recorded (log time). A topic of transforms (tf2_msgs/TFMessage)
// is a stream for each pair of frames, "/tf:map.base_link", frames without leading slashes. Names of frames
// that never change are in the metadata: "/odom header.frame_id". messages/message_decoder.hpp says what the
// channels are.
//
// The index of a bag is not needed. Memory is bounded: one chunk of the file, and the numbers of decoded
// channels, of which a recording may have 100 million. A file that was cut short gives what is before the
// cut.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Of the first bytes of a file (16 are enough).
bool is_ros1_bag(std::string_view head);
bool is_mcap(std::string_view head);
bool is_sqlite(std::string_view head);
bool is_zstd(std::string_view head);  // rosbag2 compresses whole files so

// A file of any of these kinds. One behind zstd is unpacked to the folder for temporary files.
ReadResult read_ros_file(const std::filesystem::path& path);
ReadResult read_bag_folder(const std::filesystem::path& path);

// A bag of ROS 1 or an MCAP file in memory; `name` stands for it in messages.
ReadResult read_ros_bytes(std::string_view bytes, const std::string& name);

}  // namespace wheelwright::import
