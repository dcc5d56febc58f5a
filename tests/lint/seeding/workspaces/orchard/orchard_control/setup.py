import os
from glob import glob

from setuptools import setup

package_name = 'orchard_control'

setup(
    name=package_name,
    version='0.4.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        (os.path.join('share', package_name), ['package.xml']),
        (os.path.join('share', package_name, 'config'), glob('config/*.yaml')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Mira',
    maintainer_email='mira@example.org',
    description='Row driving and harvesting',
    license='Apache-2.0',
    entry_points={
        'console_scripts': [
            f'row_driver = {package_name}.row_driver:main',
            f'supervisor = {package_name}.supervisor:main',
            'picker = orchard_control.picker:main',
        ],
    },
)
