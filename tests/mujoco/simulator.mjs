// Drives the robot of an MJCF file by the commands of a CSV file, in MuJoCo, and writes what it did as a log.
//   node simulator.mjs ROBOT.xml COMMANDS.csv OUT.csv
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import load_mujoco from '@mujoco/mujoco';

const data_sheet = { wheel_radius_m: 0.036, counts_per_turn: 508.8, wheel_base_m: 0.235 };
const settling_s = 0.5; // on the floor, before the first command

export function read_commands(path) {
  const lines = readFileSync(path, 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
  const columns = lines.shift().split(',');
  const [t, left, right] = ['t', 'cmd_left', 'cmd_right'].map((name) => columns.indexOf(name));
  return lines.map((line) => {
    const fields = line.split(',').map(Number);
    return { t_s: fields[t], left_m_s: fields[left], right_m_s: fields[right] };
  });
}

function heading(quaternion) {
  const [w, x, y, z] = quaternion;
  return Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

// The robot's own state at each row: pose, and how far its wheels have turned.
export async function simulate(robot_xml, commands) {
  const mujoco = await load_mujoco();
  const model = mujoco.MjModel.from_xml_string(robot_xml);
  const data = new mujoco.MjData(model);
  const step_s = model.opt.timestep;
  const joint = (name) => mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT.value, name);
  const [left, right] = ['left_wheel_joint', 'right_wheel_joint'].map((name) => model.jnt_qposadr[joint(name)]);
  const until = (t_s) => {
    while (data.time + step_s / 2 < settling_s + t_s) mujoco.mj_step(model, data);
  };
  until(0);
  const [left_rad, right_rad] = [data.qpos[left], data.qpos[right]];
  const [x_m, y_m] = data.qpos;
  const theta_rad = heading(data.qpos.slice(3, 7));
  const [cos, sin] = [Math.cos(theta_rad), Math.sin(theta_rad)];
  const pose = () => {
    const [x, y] = [data.qpos[0] - x_m, data.qpos[1] - y_m];
    const turned = heading(data.qpos.slice(3, 7)) - theta_rad;
    return { x_m: cos * x + sin * y, y_m: cos * y - sin * x, theta_rad: Math.atan2(Math.sin(turned), Math.cos(turned)) };
  };
  const rows = [];
  for (const command of commands) {
    until(command.t_s - commands[0].t_s);
    rows.push({
      ...command,
      ...pose(),
      left_rad: data.qpos[left] - left_rad,
      right_rad: data.qpos[right] - right_rad,
    });
    data.ctrl[0] = command.left_m_s / data_sheet.wheel_radius_m;
    data.ctrl[1] = command.right_m_s / data_sheet.wheel_radius_m;
  }
  data.delete();
  model.delete();
  return rows;
}

export function drive_log(rows) {
  const metres_per_tick = (2 * Math.PI * data_sheet.wheel_radius_m) / data_sheet.counts_per_turn;
  const ticks = (rad) => Math.round((rad / (2 * Math.PI)) * data_sheet.counts_per_turn);
  const period_s = (rows.at(-1).t_s - rows[0].t_s) / (rows.length - 1);
  return (
    `# wheelwright_drive_log: 1\n# wheel_base_m: ${data_sheet.wheel_base_m}\n# period_s: ${period_s.toFixed(6)}\n` +
    `# metres_per_tick_left: ${metres_per_tick}\n# metres_per_tick_right: ${metres_per_tick}\n` +
    't,cmd_left,cmd_right,ticks_left,ticks_right,ref_x,ref_y,ref_theta\n' +
    rows
      .map((row) =>
        [
          row.t_s.toFixed(6), row.left_m_s, row.right_m_s, ticks(row.left_rad), ticks(row.right_rad),
          row.x_m.toFixed(6), row.y_m.toFixed(6), row.theta_rad.toFixed(6),
        ].join(','),
      )
      .join('\n') +
    '\n'
  );
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [robot, commands, out] = process.argv.slice(2);
  try {
    writeFileSync(out, drive_log(await simulate(readFileSync(robot, 'utf8'), read_commands(commands))));
  } catch (error) {
    console.error(error.message);
    process.exit(1);
  }
}
