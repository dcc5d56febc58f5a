from setuptools import find_packages, setup

package_name = 'orchard_driver'

setup(
    name=package_name,
    version='0.4.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Mira',
    maintainer_email='mira@example.org',
    description='Motors, battery and cameras',
    license='Apache-2.0',
    entry_points={
        'console_scripts': [
            'motor_driver = orchard_driver.motor_driver:main',
            'battery = orchard_driver.battery:main',
            'fruit_camera = orchard_driver.fruit_camera:main',
            'status_light = orchard_driver.status_light:main',
        ],
    },
)
